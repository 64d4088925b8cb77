// SPDX-License-Identifier: MIT
// Commands for the window: screen, colours, language, who draws, lessons, the list of keys.
#include "ui/controls/command_families.h"
#include "ui/session/context.h"

namespace versorium {
namespace {

void nextTheme(StudioContext& context) {
    context.chooseTheme(themes()[(context.theme + 1) % themes().size()].name);
}

void addLessonCommands(StudioContext& context, Commands& all) {
    StudioContext* c = &context;
    const auto inLesson = [c] { return c->lessons.now.has_value(); };
    const auto step = [c](int by) {
        const auto now = static_cast<int>(c->lessons.now->session.at());
        if (now + by >= 0) goToStep(*c, static_cast<std::size_t>(now + by));
    };
    const auto add = [&](Command command) { all.push_back(harmless(std::move(command))); };
    add({"lessons",
         trLater("Show or hide the lessons"),
         trLater("Lessons that lead through an idea: predict, try, see."),
         {"L"},
         [c] {
             c->lessons.open = !c->lessons.open;
             c->host.wake();
         }});
    add({"lesson.next",
         trLater("Lesson: next step"),
         trLater("Goes on in the lesson. The step stays as you leave it."),
         {"Page Down"},
         [step] { step(1); },
         inLesson});
    add({"lesson.back",
         trLater("Lesson: previous step"),
         trLater("Goes back to the step before, as you left it."),
         {"Page Up"},
         [step] { step(-1); },
         inLesson});
    add({"lesson.reset",
         trLater("Lesson: reset the step"),
         trLater("Sets everything as the teacher set it up."),
         {},
         [c] { resetStep(*c); },
         [c] { return c->lessons.now.has_value() || c->teacher.has_value(); }});
}

}  // namespace

void addWindowCommands(StudioContext& context, Commands& all) {
    StudioContext* c = &context;
    addLessonCommands(context, all);
    all.push_back(harmless(
        {"fullscreen",
         trLater("Full screen"),
         trLater("Fills the screen with the studio; the same key brings the window back."),
         {"F", false, true},
         [c] {
             if (!c->host.toggleFullscreen())
                 c->say("The screen cannot be filled from here: the desktop's own keys may do it");
         }}));
    all.push_back(harmless({"theme.next",
                            trLater("Next theme"),
                            trLater("Dark, light, or strong contrast for a projector."),
                            {"T"},
                            [c] { nextTheme(*c); }}));
    all.push_back({"renderer.next",
                   trLater("Draw on the CPU, on the GPU, or automatically"),
                   trLater("Automatic takes whichever is faster and precise enough."),
                   {"G"},
                   [c] { c->nextRenderer(); }});
    all.push_back(harmless({"keys",
                            trLater("Keyboard shortcuts"),
                            trLater("The list of all keys, and what the pointer does in a view."),
                            {"?"},
                            [c] { c->dialogs.keys = !c->dialogs.keys; }}));
    for (const Language& language : languages())
        all.push_back(harmless({"language." + language.id,
                                tr("Language: {1}", {language.name}),
                                trLater("Menus, messages, lessons and plates in this language."),
                                {},
                                [c, id = language.id] { c->speak(id); }}));
}

}  // namespace versorium
