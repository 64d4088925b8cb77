// SPDX-License-Identifier: MIT
// The window's part of the list of controls: views, theme, language, exports, lessons, commands.
#include <algorithm>

#include "render/frame.h"
#include "ui/controls/control_list.h"

namespace versorium {

void collectWindow(StudioContext& context, ControlList& all) {
    all.begin("Window");
    StudioContext* c = &context;
    const Workspace& workspace = context.workspace;
    const auto count = static_cast<int>(workspace.views.size());
    const std::string analysis = trLater("an analysis");
    all.choice("layout", "number of views", workspace.analysis() ? analysis : std::to_string(count),
               {"1", "2", "4", analysis}, [c, analysis](const std::string& wanted) {
                   if (wanted != analysis) return setViewCount(c->workspace, std::stoi(wanted));
                   if (!setAnalysis(c->workspace))
                       c->say("This map has no two parameters that could be the axes of a set");
               });
    std::vector<std::string> views;
    for (int k = 1; k <= count; ++k) views.push_back(std::to_string(k));
    all.choice("marked", "marked view", std::to_string(workspace.focused + 1), views,
               [c](const std::string& wanted) { c->mark(std::stoi(wanted) - 1); });
    all.values({"maximised"});
    std::vector<std::string> names;
    for (const StudioTheme& theme : themes()) names.push_back(theme.name);
    all.choice("theme", "theme", names[context.theme], names, [c, names](const std::string& name) {
        c->theme =
            static_cast<std::size_t>(std::find(names.begin(), names.end(), name) - names.begin());
        c->host.store("theme", name);
        c->fontsChanged = true;
    });
    std::vector<std::string> ids, spoken;
    for (const Language& language : languages())
        ids.push_back(language.id), spoken.push_back(language.name);
    all.choice(
        "language", "language", languageNow().id, ids, [c](const std::string& id) { c->speak(id); },
        spoken);
    all.choice("renderer", "who draws live pictures", std::string(wordOf(context.renderer)),
               wordsOf<RendererChoice>(),
               [c](const std::string& wanted) { c->choose(*fromWord<RendererChoice>(wanted)); });
    all.number("export", "pixels wide of an export", context.exporting.width, 100, 16, kMostPixels,
               [c](double value) { c->exporting.width = static_cast<int>(value); });
    all.command("begin export", "Export the marked view now", "", [c] { c->startExport(); });
    if (context.host.exportProgress() >= 0)
        all.command("cancel export", "Cancel the export", "", [c] { c->host.cancelExport(); });
}

void collectLessons(StudioContext& context, ControlList& all) {
    all.begin("Lessons");
    StudioContext* c = &context;
    const std::string now = context.lessons.now && context.lessons.now->own
                                ? context.lessons.now->session.lesson().id
                                : std::string();
    all.choice("lesson", "open a lesson", now, lessonIds(),
               [c](const std::string& id) { c->report(openLesson(*c, id, {})); });
    if (context.teacher && context.teacher->view)
        all.command("teacher reset", "Reset to the teacher's view", "", [c] { resetStep(*c); });
    if (!context.lessons.now) return;
    const auto count = static_cast<double>(context.lessons.now->left.size());
    all.number("lesson step", "step of the lesson",
               static_cast<double>(context.lessons.now->session.at()) + 1, 1, 1, count,
               [c](double value) { goToStep(*c, static_cast<std::size_t>(value) - 1); });
}

void collectCommands(StudioContext& context, ControlList& all) {
    all.begin("Commands");
    for (Command& command : commandsOf(context))
        all.command("do " + command.id, command.title(), nameOf(command.chord),
                    std::move(command.run));
}

}  // namespace versorium
