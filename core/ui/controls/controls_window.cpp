// SPDX-License-Identifier: MIT
// The window's part of the list of controls: views, theme, language, exports, lessons, commands.
#include <algorithm>

#include "ui/controls/commands.h"
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
                   const bool set = c->edit([&](Workspace& w) {
                       if (wanted == analysis) return setAnalysis(w);
                       setViewCount(w, std::stoi(wanted));
                       return true;
                   });
                   if (!set)
                       c->say("This map has no two parameters that could be the axes of a set");
               });
    std::vector<std::string> views;
    for (int k = 1; k <= count; ++k) views.push_back(std::to_string(k));
    all.choice("marked", "focused view", std::to_string(workspace.focused + 1), views,
               [c](const std::string& wanted) { c->focus(std::stoi(wanted) - 1); });
    all.values({"maximised"});
    all.values({"theme", "language", "renderer", "export.width"});
    all.command("begin export", "Export the focused view now", "", [c] { c->startExport(); });
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
