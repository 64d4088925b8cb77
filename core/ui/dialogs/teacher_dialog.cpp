// SPDX-License-Identifier: MIT
// The dialog that makes a teacher's link, or the snippet that shows it within another page.
#include <algorithm>

#include "ui/controls/access.h"
#include "ui/controls/controls.h"
#include "ui/dialogs/dialogs.h"
#include "ui/session/context.h"
#include "ui/widgets/help.h"
#include "ui/widgets/panel_parts.h"

namespace versorium {
namespace {

const std::vector<std::string>& restWords() {
    static const std::vector<std::string> words = {"open", "locked", "hidden", "step"};
    return words;
}

std::string restOf(const TeacherLink& link) {
    return link.byStep ? "step" : restWords()[static_cast<std::size_t>(link.rest)];
}

void setRest(TeacherLink& link, const std::string& word) {
    link.byStep = word == "step";
    const auto found = std::find(restWords().begin(), restWords().end(), word);
    link.rest = link.byStep ? Access::hidden : static_cast<Access>(found - restWords().begin());
}

// One line for each control: as all others, open, locked or hidden.
void drawNames(StudioContext& context) {
    TeacherLink& link = context.panels.of<TeacherDialog>().link;
    ImGui::BeginChild("names", {0, 12 * ImGui::GetFontSize()});
    for (const Control& control : controlsOf(context)) {
        if (control.kind == ControlKind::command) continue;
        ImGui::PushID(control.id.c_str());
        const auto found = link.named.find(control.id);
        std::string word =
            found == link.named.end() ? "" : restWords()[static_cast<std::size_t>(found->second)];
        ImGui::SetNextItemWidth(8 * ImGui::GetFontSize());
        if (choose(control.label.c_str(), "control access", word, {"", "open", "locked", "hidden"},
                   "as all others")) {
            if (word.empty())
                link.named.erase(control.id);
            else
                link.named[control.id] = static_cast<Access>(
                    std::find(restWords().begin(), restWords().end(), word) - restWords().begin());
        }
        ImGui::PopID();
    }
    ImGui::EndChild();
}

}  // namespace

Expected<std::string> teacherAddress(StudioContext& context) {
    TeacherLink& link = context.panels.of<TeacherDialog>().link;
    const bool lesson = context.panels.of<TeacherDialog>().withLesson && context.lessons.now &&
                        context.lessons.now->own;
    link.lesson = lesson ? context.lessons.now->session.lesson().id : "";
    link.step.reset();
    if (lesson) link.step = static_cast<int>(context.lessons.now->session.at());
    link.byStep = link.byStep && lesson;
    if (lesson)
        link.view.reset();
    else
        link.view.emplace(context.workspace);
    const std::string address = context.host.publicAddress();
    if (address.empty())
        return Status::usage(
            "No public address is known that a link could begin with: set public_url in the "
            "settings");
    Expected<std::string> text = teacherLinkText(link);
    if (!text) return text;
    return address + "#" + *text;
}

void copyTeacherLink(StudioContext& context, bool asFrame) {
    const Expected<std::string> address = teacherAddress(context);
    if (!address) return context.report(address.status());
    const bool lesson = context.panels.of<TeacherDialog>().withLesson && context.lessons.now;
    const std::string title = lesson ? context.lessons.now->session.lesson().title
                                     : std::string(mapOf(context.workspace.views[0]).info.title);
    context.panels.of<TeacherDialog>().made =
        asFrame ? iframeOf(*address, "Versorium: " + title) : *address;
    context.host.setClipboard(context.panels.of<TeacherDialog>().made);
    context.say(asFrame ? "The snippet for a web page is on the clipboard"
                        : "The teacher's link is on the clipboard");
}

void drawTeacherDialog(StudioContext& context) {
    TeacherDialog& dialog = context.panels.of<TeacherDialog>();
    const std::string window = named("A teacher's link");
    if (context.dialogs.teacher && !ImGui::IsPopupOpen(window.c_str())) {
        ImGui::OpenPopup(window.c_str());
        dialog.withLesson = context.lessons.now && context.lessons.now->own;
    }
    const ImGuiViewport& screen = *ImGui::GetMainViewport();
    ImGui::SetNextWindowPos(screen.GetCenter(), ImGuiCond_Always, {0.5f, 0.5f});
    ImGui::SetNextWindowSize({std::min(560.0f * context.scale, screen.Size.x * 0.96f), 0});
    if (!ImGui::BeginPopupModal(window.c_str(), &context.dialogs.teacher,
                                ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove))
        return;
    TeacherLink& link = dialog.link;
    if (context.lessons.now && context.lessons.now->own) {
        const std::vector<std::string> both = {trLater("this step of the lesson"),
                                               trLater("this view")};
        std::string what = both[dialog.withLesson ? 0 : 1];
        if (choose("opens", "link opens", what, both)) dialog.withLesson = what == both[0];
    }
    std::string rest = restOf(link);
    std::vector<std::string> words = restWords();
    if (!dialog.withLesson) words.pop_back();
    if (choose("controls", "link rest", rest, words)) setRest(link, rest);
    std::vector<std::string> names{""};
    for (const StudioTheme& theme : themes()) names.push_back(theme.name);
    choose("theme", "link theme", link.theme, names, "the learner's own");
    std::vector<std::string> spoken{""};
    for (const Language& language : languages()) spoken.push_back(language.id);
    chooseName("language", "link language", link.language, spoken, "the learner's own");
    if (section("Single controls", !link.named.empty())) drawNames(context);
    ImGui::Spacing();
    if (ImGui::Button(tr("Copy the link"))) copyTeacherLink(context, false);
    explain("copy teacher link");
    ImGui::SameLine();
    if (ImGui::Button(tr("Copy a snippet for a web page"))) copyTeacherLink(context, true);
    explain("copy frame");
    ImGui::SameLine();
    if (ImGui::Button(tr("Close")) || ImGui::IsKeyPressed(ImGuiKey_Escape))
        context.dialogs.teacher = false;
    explain("close dialog");
    if (!dialog.made.empty()) {
        ImGui::PushTextWrapPos();
        ImGui::TextDisabled("%s", dialog.made.c_str());
        ImGui::PopTextWrapPos();
    }
    if (!context.dialogs.teacher) ImGui::CloseCurrentPopup();
    ImGui::EndPopup();
}

}  // namespace versorium
