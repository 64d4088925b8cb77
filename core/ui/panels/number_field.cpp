// SPDX-License-Identifier: MIT
#include "ui/panels/number_field.h"

#include <algorithm>
#include <cmath>

#include "ui/controls/access.h"
#include "ui/widgets/help.h"
#include "ui/widgets/shown_number.h"

namespace versorium {
namespace {

void toggleAnimation(StudioContext& context, const std::string& name, double low, double high) {
    Player::Animation& animation = context.player.animation;
    if (animation.running && animation.number == name)
        animation.running = false;
    else
        context.player.animate(name, low, high);
}

void drawMenu(StudioContext& context, const std::string& name, const std::string& title,
              double& value, const NumberLook& look, std::array<double, 2> range) {
    ImGui::TextDisabled("%s", title.c_str());
    ImGui::PushItemWidth(ImGui::GetFontSize() * 9);
    const double step = look.whole ? 1 : (range[1] - range[0]) / 4000;
    dragNumber(tr("exact value"), value, step, look.whole ? "%.0f" : "%.15g");
    explain("exact value");
    std::array<double, 2> next = range;
    bool moved = dragNumber(tr("range low"), next[0], step, "%.6g");
    explain("range low");
    moved |= dragNumber(tr("range high"), next[1], step, "%.6g");
    explain("range high");
    if (moved && next[0] < next[1] && (!look.logarithmic || next[0] > 0)) {
        context.edit([&](Workspace& w) { w.ranges[name] = next; });
    }
    if (ImGui::Button(tr("Usual range"))) {
        context.edit([&](Workspace& w) { w.ranges.erase(name); });
    }
    explain("range reset");
    if (look.home) {
        ImGui::SameLine();
        if (ImGui::Button(tr("Reset"))) value = *look.home;
        explain("reset");
    }
    if (look.animated) {
        // Any two numbers of a map are the axes of a set, two clicks away.
        ImGui::AlignTextToFramePadding();
        ImGui::TextUnformatted(tr("axis of a set:"));
        for (std::size_t axis = 0; axis < 2; ++axis) {
            ImGui::SameLine();
            if (ImGui::Button(axis == 0 ? tr("→ across") : tr("↑ up"))) {
                context.edit([&](Workspace& w) { makeAxis(w, axis, name); });
                context.studies.newestAxis = static_cast<int>(axis);
            }
            explain("make axis");
        }
        const bool runs =
            context.player.animation.running && context.player.animation.number == name;
        if (ImGui::Button(runs ? tr("Stop") : tr("Animate")))
            toggleAnimation(context, name, range[0], range[1]);
        explain("animate");
        double seconds = context.player.animation.seconds;
        if (dragNumber(tr("seconds"), seconds, 0.05, "%.3g") && seconds >= 0.5 && seconds <= 3600)
            context.player.animation.seconds = seconds;
        explain("seconds");
        ImGui::Checkbox(tr("to and fro"), &context.player.animation.toAndFro);
        explain("to and fro");
    }
    ImGui::PopItemWidth();
}

std::array<double, 2> rangeOf(const StudioContext& context, const std::string& name,
                              const NumberLook& look) {
    const auto own = context.workspace.ranges.find(name);
    return own != context.workspace.ranges.end() ? own->second
                                                 : std::array<double, 2>{look.low, look.high};
}

bool menuButton(StudioContext& context, const std::string& name, const std::string& title,
                double& value, const NumberLook& look, float width) {
    const double before = value;
    if (ImGui::Button("…", {width, 0})) ImGui::OpenPopup("menu");
    explain("number menu");
    if (ImGui::BeginPopup("menu")) {
        drawMenu(context, name, title, value, look, rangeOf(context, name, look));
        ImGui::EndPopup();
    }
    return value != before;
}

}  // namespace

bool numberCell(StudioContext& context, const std::string& name, double& value,
                const NumberLook& look, float width) {
    const double before = value;
    const std::array<double, 2> range = rangeOf(context, name, look);
    const float button = ImGui::GetFontSize();
    ImGui::PushID(name.c_str());
    ImGui::SetNextItemWidth(width - button - 2);
    // What is 0 steps back, so that the formula stands out.
    if (value == 0) ImGui::PushStyleColor(ImGuiCol_Text, ImGui::GetColorU32(ImGuiCol_TextDisabled));
    const bool zero = value == 0;
    dragNumber("##box", value, (range[1] - range[0]) / 4000, "%.4g");
    if (zero) ImGui::PopStyleColor();
    explainBy(look.help);
    ImGui::SameLine(0, 2);
    menuButton(context, name, name, value, look, button);
    ImGui::PopID();
    return value != before;
}

bool numberField(StudioContext& context, const std::string& name, const std::string& label,
                 double& value, const NumberLook& look) {
    const Access access = accessOf(context, name);
    if (access == Access::hidden) return false;
    const double before = value;
    const std::array<double, 2> range = rangeOf(context, name, look);
    const float letter = ImGui::GetFontSize(), gap = 4 * context.scale;
    const float box = letter * 5.2f, button = letter * 1.5f;
    const float buttons = (look.animated ? 2 : 1) * (button + gap);
    ImGui::PushID(name.c_str());
    ImGui::BeginDisabled(access == Access::locked);
    const float left = ImGui::GetCursorPosX();
    const float right = left + ImGui::GetContentRegionAvail().x;
    ImGui::AlignTextToFramePadding();
    // Names of parameters stay as formulas have them.
    const std::string shown = look.animated ? label : tr(std::string_view(label));
    ImGui::TextUnformatted(shown.c_str());
    explainBy(look.help);
    const char* format = look.whole ? "%.0f" : "%.6g";
    if (look.slider) {
        const float begin = left + std::max(letter * 6.8f, ImGui::GetItemRectSize().x + gap);
        ImGui::SameLine();
        ImGui::SetCursorPosX(begin);
        ImGui::SetNextItemWidth(std::max(letter, right - buttons - box - gap - begin));
        double slid = value;
        if (ImGui::SliderScalar("##slider", ImGuiDataType_Double, &slid, &range[0], &range[1], "",
                                look.logarithmic ? ImGuiSliderFlags_Logarithmic : 0) &&
            std::isfinite(slid))
            value = slid;
        explainBy(look.help);
    }
    ImGui::SameLine();
    ImGui::SetCursorPosX(right - buttons - box);
    ImGui::SetNextItemWidth(box);
    dragNumber("##box", value,
               look.whole ? std::max(0.5, std::abs(value) / 200) : (range[1] - range[0]) / 4000,
               format);
    explainBy(look.help);
    if (look.animated) {
        ImGui::SameLine(0, gap);
        const bool mine =
            context.player.animation.running && context.player.animation.number == name;
        if (mine ? ImGui::Button("■", {button, 0}) : ImGui::ArrowButton("play", ImGuiDir_Right))
            toggleAnimation(context, name, range[0], range[1]);
        explain("animate");
    }
    ImGui::SameLine(0, gap);
    ImGui::SetCursorPosX(right - button);
    menuButton(context, name, look.animated ? name : shown, value, look, button);
    ImGui::EndDisabled();
    ImGui::PopID();
    if (look.whole) value = std::round(value);
    return value != before;
}

}  // namespace versorium
