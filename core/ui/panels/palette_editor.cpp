// SPDX-License-Identifier: MIT
// The palette of the focused view: which one, and its stops.
#include <algorithm>
#include <cmath>

#include "ui/panels/panels.h"
#include "ui/session/context.h"
#include "ui/widgets/help.h"
#include "ui/widgets/palette_stops.h"
#include "ui/widgets/panel_parts.h"
#include "ui/widgets/shown_number.h"

namespace versorium {
namespace {

ImU32 screenColour(const Colour& colour) {
    const Colour shown = clipped(colour);
    return IM_COL32(srgbByte(shown.r), srgbByte(shown.g), srgbByte(shown.b), 255);
}

bool colourField(const char* label, Colour& colour, const char* control) {
    const DisplayColour shown = displayFromColour(colour);
    float v[4] = {static_cast<float>(shown.r), static_cast<float>(shown.g),
                  static_cast<float>(shown.b), static_cast<float>(shown.a)};
    const bool changed =
        ImGui::ColorEdit4(named(label).c_str(), v,
                          ImGuiColorEditFlags_NoInputs | ImGuiColorEditFlags_AlphaPreviewHalf);
    explain(control);
    if (changed) colour = colourFromDisplay({v[0], v[1], v[2], v[3]});
    return changed;
}

// The bar with its stops; true when one was moved or added.
bool drawStops(StudioContext& context, Palette& palette) {
    int& chosen = context.panels.of<PaletteStopChoice>().at;
    const float wide = ImGui::GetContentRegionAvail().x, tall = ImGui::GetFrameHeight() * 1.6f;
    const float reach = 7 * context.scale;
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    ImGui::InvisibleButton("stops", {wide, tall});
    explain("stops");
    const float left = corner.x + reach, length = wide - 2 * reach;
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    const double at = std::clamp((mouse.x - left) / length, 0.0f, 1.0f);
    bool changed = false;
    if (ImGui::IsItemActivated()) {
        chosen = -1;
        double nearest = 1.6 * reach / length;
        for (std::size_t k = 0; k < palette.stops().size(); ++k) {
            const double away = std::abs(palette.stops()[k].position - at);
            if (away < nearest) nearest = away, chosen = static_cast<int>(k);
        }
    }
    if (ImGui::IsItemHovered() && ImGui::IsMouseDoubleClicked(0) && chosen < 0) {
        chosen = addStop(palette, at);
        changed = chosen >= 0;
    } else if (ImGui::IsItemActive() && chosen >= 0 && ImGui::GetIO().MouseDelta.x != 0) {
        moveStop(palette, chosen, at);
        changed = true;
    }
    const bool mayDelete = ImGui::IsItemHovered() || ImGui::IsItemFocused();
    if (mayDelete && !ImGui::GetIO().WantTextInput && ImGui::IsKeyPressed(ImGuiKey_Delete))
        changed = deleteStop(palette, chosen) || changed;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float bottom = corner.y + tall * 0.62f;
    for (int x = 0; x < static_cast<int>(length); ++x)
        list.AddRectFilled({left + static_cast<float>(x), corner.y},
                           {left + static_cast<float>(x) + 1, bottom},
                           screenColour(palette.at(x / std::max(1.0, length - 1.0))));
    for (std::size_t k = 0; k < palette.stops().size(); ++k) {
        const PaletteStop& stop = palette.stops()[k];
        const float x = left + static_cast<float>(stop.position) * length;
        const bool now = static_cast<int>(k) == chosen;
        const ImVec2 a{x, bottom - 3}, b{x + reach, corner.y + tall}, c{x - reach, corner.y + tall};
        list.AddTriangleFilled(a, b, c, screenColour(stop.colour));
        list.AddTriangle(a, b, c,
                         ImGui::GetColorU32(now ? ImGuiCol_CheckMark : ImGuiCol_TextDisabled),
                         now ? 2.5f : 1.0f);
    }
    return changed;
}

bool drawChosen(StudioContext& context, Palette& palette) {
    bool changed = false;
    int& chosen = context.panels.of<PaletteStopChoice>().at;
    if (chosen >= static_cast<int>(palette.stops().size())) chosen = -1;
    if (chosen >= 0) {
        Colour colour = palette.stops()[static_cast<std::size_t>(chosen)].colour;
        if (colourField("stop", colour, "stop colour")) {
            colourStop(palette, chosen, colour);
            changed = true;
        }
        ImGui::SameLine();
        double position = palette.stops()[static_cast<std::size_t>(chosen)].position;
        ImGui::SetNextItemWidth(ImGui::GetFontSize() * 4.5f);
        if (dragNumber("##position", position, 0.002, "%.4g")) {
            moveStop(palette, chosen, position);
            changed = true;
        }
        explain("stop position");
        ImGui::SameLine();
        if (ImGui::Button(tr("Remove"))) {
            changed |= deleteStop(palette, chosen);
            chosen = -1;
        }
        explain("delete stop");
        ImGui::SameLine();
    }
    if (ImGui::Button(tr("Add"))) {
        std::size_t widest = 1;
        const auto gap = [&](std::size_t k) {
            return palette.stops()[k].position - palette.stops()[k - 1].position;
        };
        for (std::size_t k = 2; k < palette.stops().size(); ++k)
            if (gap(k) > gap(widest)) widest = k;
        if (palette.stops().size() > 1) {
            chosen = addStop(palette, palette.stops()[widest].position - 0.5 * gap(widest));
            changed = changed || chosen >= 0;
        }
    }
    explain("add stop");
    return changed;
}

}  // namespace

void drawPaletteEditor(StudioContext& context) {
    const Colouring& colour = context.workspace.view().colour;
    Expected<Palette> found = colour.ownPalette.is_null() ? paletteNamed(colour.palette)
                                                          : paletteFromJson(colour.ownPalette);
    if (!found) return;
    Palette palette = std::move(*found);
    if (colour.ownPalette.is_null()) {
        // Looked at here, changed only once it is the scene's own.
        const ImVec2 corner = ImGui::GetCursorScreenPos();
        const float wide = ImGui::GetContentRegionAvail().x, tall = ImGui::GetFrameHeight() * 0.7f;
        ImGui::InvisibleButton("bar", {wide, tall});
        const bool clicked = ImGui::IsItemClicked();
        explain("edit palette");
        ImDrawList& list = *ImGui::GetWindowDrawList();
        for (int x = 0; x < static_cast<int>(wide); ++x) {
            const double part = x / std::max(1.0, wide - 1.0);
            list.AddRectFilled({corner.x + static_cast<float>(x), corner.y},
                               {corner.x + static_cast<float>(x) + 1, corner.y + tall},
                               screenColour(palette.at(colour.reverse ? 1 - part : part)));
        }
        const bool pressed = ImGui::Button(tr("Edit its stops"));
        explain("edit palette");
        if (!pressed && !clicked) return;
        palette = ownPaletteFrom(palette);
        context.panels.of<PaletteStopChoice>().at = -1;
        return context.edit([&](Workspace& w) {
            w.view().colour.palette = palette.name();
            w.view().colour.ownPalette = paletteToJson(palette);
        });
    }
    bool changed = drawStops(context, palette);
    changed |= drawChosen(context, palette);
    if (ImGui::Button(tr("Turn round"))) {
        turnStops(palette);
        changed = true;
    }
    explain("turn stops");
    ImGui::SameLine();
    if (colourField("interior", palette.interior, "interior colour")) changed = true;
    ImGui::SameLine();
    if (ImGui::Button(tr("Copy"))) {
        context.host.setClipboard(printJson(paletteToJson(palette)));
        context.say("The palette is on the clipboard, as JSON");
    }
    explain("copy palette");
    if (!changed) return;
    context.edit([&](Workspace& w) { w.view().colour.ownPalette = paletteToJson(palette); });
}

}  // namespace versorium
