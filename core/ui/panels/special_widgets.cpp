// SPDX-License-Identifier: MIT
#include "ui/panels/special_widgets.h"
#include "ui/panels/panels.h"

#include <algorithm>
#include <cmath>

#include "render/colouring.h"
#include "ui/panels/number_field.h"
#include "ui/panels/value_widgets.h"
#include "ui/session/context.h"
#include "ui/widgets/help.h"
#include "ui/widgets/panel_parts.h"

namespace versorium {
namespace {

// The names, and below them the editor of the palette's stops.
bool drawPalette(StudioContext& context, const Control& control) {
    const bool set = drawControl(context, control);
    ImGui::PushID("palette editor");
    drawPaletteEditor(context);
    ImGui::PopID();
    return set;
}

// The values at the palette's ends, in units in which shifting and stretching are linear.
bool drawRange(StudioContext& context, const Control&) {
    const Scene& scene = context.workspace.view();
    Colouring colour = scene.colour;
    const OrbitProgram* program = context.bound.program(context.workspace.focused);
    if (!program) return false;
    const Expected<ColourPass> pass = ColourPass::make(scene, *program);
    bool own = !colour.range.empty(), changed = false;
    const bool toggled = ImGui::Checkbox(tr("a range of your own"), &own);
    explain("own range");
    if (toggled) {
        colour.range.clear();
        if (own && pass) colour.range = {pass->scale().low, pass->scale().high};
        if (own && colour.reverse && pass) std::swap(colour.range[0], colour.range[1]);
        context.edit([&](Workspace& w) { w.view().colour = colour; });
        return true;
    }
    if (!own || !pass) return false;
    const bool log = pass->scale().kind == ScaleKind::log;
    std::vector<double> next = colour.range;
    const double span = std::abs(next[1] - next[0]);
    for (std::size_t k = 0; k < 2; ++k) {
        const char* label = k == 0 ? trLater("from") : trLater("to");
        changed |= numberField(context, std::string("colour ") + label, label, next[k],
                               {.help = helpOf(k == 0 ? "range from" : "range to"),
                                .low = log ? std::min(1e-3, std::min(next[0], next[1]))
                                           : std::min(next[0], next[1]) - span,
                                .high = log ? 1e4 : std::max(next[0], next[1]) + span,
                                .logarithmic = log});
    }
    const auto dragged = [&](const char* label, const char* control) {
        ImGui::Button(named(label).c_str());
        explain(control);
        const float moved = ImGui::IsItemActive() ? ImGui::GetIO().MouseDelta.x : 0;
        return static_cast<double>(moved) / 300;
    };
    double low = log ? std::log(next[0]) : next[0], high = log ? std::log(next[1]) : next[1];
    const double shift = dragged("↔ shift", "shift range") * (high - low);
    ImGui::SameLine();
    const double stretch = 0.5 * dragged("↔ stretch", "stretch range") * (high - low);
    if (shift != 0 || stretch != 0) {
        low += shift - stretch, high += shift + stretch;
        next = {log ? std::exp(low) : low, log ? std::exp(high) : high};
        changed = true;
    }
    const Scale scale{pass->scale().kind, next[0], next[1]};
    if (!changed || !scale.check().ok()) return false;
    context.edit([&](Workspace& w) { w.view().colour.range = next; });
    return true;
}

}  // namespace

SpecialWidget specialWidget(std::string_view path) {
    constexpr std::pair<std::string_view, SpecialWidget> kWidgets[] = {
        {"colour.palette", drawPalette}, {"colour.range", drawRange}};
    for (const auto& [name, widget] : kWidgets)
        if (name == path) return widget;
    return nullptr;
}

}  // namespace versorium
