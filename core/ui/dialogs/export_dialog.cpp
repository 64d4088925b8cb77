// SPDX-License-Identifier: MIT
// What to export, how large, and how far it is.
#include <algorithm>
#include <cmath>

#include "plate/plate_picture.h"
#include "render/frame.h"
#include "ui/dialogs/dialogs.h"
#include "ui/session/context.h"
#include "ui/widgets/help.h"
#include "ui/widgets/panel_parts.h"
#include "ui/widgets/shown_number.h"

namespace versorium {
namespace {

bool radio(const char* label, const char* control, bool now) {
    const bool chosen = ImGui::RadioButton(tr(label), now);
    explain(control);
    return chosen;
}

void pictureOptions(StudioContext& context, ExportOptions& options) {
    ImGui::InputInt(tr("pixels wide"), &options.width, 100, 1000);
    explain("pixels wide");
    options.width = std::clamp(options.width, 16, kMostPixels);
    ImGui::SameLine();
    ImGui::TextDisabled("× %ld",
                        std::lround(options.width / context.aspect(context.workspace.focused)));
}

void motionOptions(StudioContext& context, ExportOptions& options) {
    if (context.host.makesFilms()) {
        if (radio("pictures in a ZIP", "film kind", !options.film)) options.film = false;
        ImGui::SameLine();
        if (radio("film (WebM)", "film kind", options.film)) options.film = true;
    }
    const Motion& motion = context.workspace.motion;
    ImGui::TextUnformatted(tr("{1} pictures of {2} s",
                              {std::to_string(motion.frames()), shownNumber(motion.duration(), 4)})
                               .c_str());
}

void plateOptions(StudioContext& context, ExportOptions& options) {
    const char* views = tr("what is shown");
    const bool open = ImGui::BeginCombo(named("of").c_str(),
                                        options.builtIn.empty() ? views : options.builtIn.c_str(),
                                        ImGuiComboFlags_HeightLarge);
    if (!open) explain("plate of");
    if (open) {
        if (ImGui::Selectable(views, options.builtIn.empty())) options.builtIn.clear();
        for (const std::string& name : plateNames())
            if (ImGui::Selectable(name.c_str(), name == options.builtIn)) options.builtIn = name;
        ImGui::EndCombo();
    }
    if (context.workspace.views.size() > 1 && options.builtIn.empty()) {
        if (radio("focused view", "export what", !options.allViews)) options.allViews = false;
        ImGui::SameLine();
        if (radio("all views", "export what", options.allViews)) options.allViews = true;
    }
    dragNumber(tr("mm wide"), options.millimetres, 1, "%.4g", 60, 2000);
    explain("plate width");
    dragNumber(tr("pixels per inch"), options.dotsPerInch, 5, "%.4g", 50, 2400);
    explain("plate dpi");
    if (radio("paper", "plate theme", options.theme == "paper")) options.theme = "paper";
    ImGui::SameLine();
    if (radio("slide", "plate theme", options.theme == "slide")) options.theme = "slide";
    ImGui::SameLine();
    ImGui::Checkbox(tr("title"), &options.title);
    explain("plate title");
    ImGui::SameLine();
    ImGui::Checkbox(tr("caption"), &options.caption);
    explain("plate caption");
}

}  // namespace

void drawExport(StudioContext& context) {
    const std::string window = named("Export");
    if (context.dialogs.exporting && !ImGui::IsPopupOpen(window.c_str()))
        ImGui::OpenPopup(window.c_str());
    ImGui::SetNextWindowPos(ImGui::GetMainViewport()->GetCenter(), ImGuiCond_Always, {0.5f, 0.5f});
    if (!ImGui::BeginPopupModal(window.c_str(), &context.dialogs.exporting,
                                ImGuiWindowFlags_AlwaysAutoResize))
        return;
    ExportOptions& options = context.exporting;
    const double progress = context.host.exportProgress();
    ImGui::PushItemWidth(ImGui::GetFontSize() * 11);
    ImGui::BeginDisabled(progress >= 0);
    options.motion = options.motion && !context.workspace.motion.keys.empty();
    const auto kind = [&](const char* label, bool plate, bool motion) {
        if (radio(label, "export kind", options.plate == plate && options.motion == motion))
            options.plate = plate, options.motion = motion;
        ImGui::SameLine();
    };
    kind("picture", false, false);
    kind("plate", true, false);
    if (!context.workspace.motion.keys.empty()) kind("motion", false, true);
    ImGui::NewLine();
    if (options.motion) motionOptions(context, options);
    if (options.plate)
        plateOptions(context, options);
    else
        pictureOptions(context, options);
    int samples = context.workspace.view().samples;
    if (ImGui::DragInt(tr("samples along a pixel"), &samples, 0.05f, 1, kMostSamples, "%d",
                       ImGuiSliderFlags_AlwaysClamp))
        context.edit([&](Workspace& w) {
            for (Scene& scene : w.views) scene.samples = samples;
        });
    explain("samples");
    ImGui::TextDisabled("%s", options.motion
                                  ? tr("Each PNG carries its scene: it can be opened again.")
                                  : tr("The PNG carries its scene: it can be opened again."));
    const bool enter =
        progress < 0 && !ImGui::GetIO().WantTextInput && ImGui::IsKeyPressed(ImGuiKey_Enter, false);
    if (ImGui::Button(tr("Export")) || enter) context.startExport();
    explain("export");
    ImGui::SameLine();
    if (ImGui::Button(tr("Copy image"))) context.copyImage();
    explain("copy image");
    ImGui::EndDisabled();
    ImGui::SameLine();
    if (progress >= 0) {
        ImGui::ProgressBar(static_cast<float>(progress), {ImGui::GetFontSize() * 8, 0});
        ImGui::SameLine();
        if (ImGui::Button(tr("Cancel"))) context.host.cancelExport();
        explain("cancel");
    } else {
        const bool closed = ImGui::Button(tr("Close"));
        explain("close");
        if (closed || ImGui::IsKeyPressed(ImGuiKey_Escape)) {
            context.dialogs.exporting = false;
            ImGui::CloseCurrentPopup();
        }
    }
    ImGui::PopItemWidth();
    if (const std::string& notice = context.notices.shown(); !notice.empty()) {
        ImGui::PushTextWrapPos(ImGui::GetFontSize() * 26);
        ImGui::TextUnformatted(notice.c_str());
        ImGui::PopTextWrapPos();
    }
    ImGui::EndPopup();
}

}  // namespace versorium
