// SPDX-License-Identifier: MIT
// The strip's bifurcation diagram: the attractor against one parameter, filled a few columns in a
// frame. The line stands at the present value and is dragged; the wheel zooms along the parameter,
// a drag with the right button moves along it.
#include <algorithm>
#include <cmath>

#include "ui/backend/texture.h"
#include "ui/plots/plots.h"
#include "ui/session/context.h"
#include "ui/widgets/help.h"
#include "ui/widgets/shown_number.h"

namespace versorium {
namespace {

constexpr double kWheel = 0.8;
constexpr int kMostColumns = 1200;

std::string periodText(int period) {
    if (period > 0) return tr("period {1}", {std::to_string(period)});
    return period < 0 ? tr("escapes") : tr("bounded, no cycle found");
}

void put(StudioContext& context, DiagramStudy& study) {
    // Without a renderer, as in tests, there are no textures.
    if (!ImGui::GetIO().BackendRendererName || !study.diagram) return;
    if (study.textured == study.filled && study.theme == context.theme && study.texture) return;
    const Size size = study.diagram->visits.size();
    // Not after every few columns: all of them are coloured each time.
    constexpr int kBatch = 60;
    if (study.texture && study.filled < size.width && study.filled > study.textured &&
        study.filled - study.textured < kBatch)
        return;
    const Raster<float> ink = inkOf(*study.diagram, study.options);
    const ImVec4 colour = ImGui::GetStyleColorVec4(ImGuiCol_Text);
    std::vector<unsigned char> rgba;
    rgba.reserve(static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height) * 4);
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x) {
            for (const float part : {colour.x, colour.y, colour.z})
                rgba.push_back(static_cast<unsigned char>(std::lround(255 * part)));
            rgba.push_back(static_cast<unsigned char>(
                std::lround(255 * std::clamp(ink.at(x, y), 0.0f, 1.0f))));
        }
    study.texture = putTexture(study.texture, size, rgba.data());
    study.textured = study.filled;
    study.theme = context.theme;
}

void keep(StudioContext& context, const Workspace::Diagram& diagram) {
    if (!(diagram.right - diagram.left > 1e-9) || std::abs(diagram.left) > 1e6 ||
        std::abs(diagram.right) > 1e6 || context.workspace.diagram == diagram)
        return;
    context.edit([&](Workspace& w) { w.diagram = diagram; });
}

void drawHead(StudioContext& context) {
    const Workspace& workspace = context.workspace;
    Workspace::Diagram diagram = diagramOf(workspace);
    const MapInfo& info = mapOf(workspace.views[0]).info;
    const float letter = ImGui::GetFontSize();
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2(4, 0));
    ImGui::SetNextItemWidth(letter * 7);
    const bool open = ImGui::BeginCombo("##diagram number", diagram.number.c_str());
    if (!open) explain("diagram number");
    if (open) {
        for (int k = 0; k < parameterSize(info); ++k) {
            const std::string name = parameterComponent(info, k);
            if (ImGui::Selectable(name.c_str(), name == diagram.number) && name != diagram.number)
                context.edit([&](Workspace& w) { setDiagramNumber(w, name); });
        }
        ImGui::EndCombo();
    }
    const double speed = (diagram.right - diagram.left) / 400;
    bool moved = false;
    for (const bool left : {true, false}) {
        ImGui::SameLine(0, 8);
        ImGui::TextUnformatted(left ? tr("from") : tr("to"));
        ImGui::SameLine(0, 4);
        ImGui::SetNextItemWidth(letter * 4.6f);
        double& end = left ? diagram.left : diagram.right;
        moved |= dragNumber(left ? "##from" : "##to", end, speed, "%.6g");
        explain("diagram range");
    }
    ImGui::PopStyleVar();
    if (moved && std::isfinite(diagram.left) && std::isfinite(diagram.right))
        keep(context, diagram);
    ImGui::SameLine(0, 8);
    if (ImGui::SmallButton(tr("usual range")))
        context.edit([](Workspace& w) { w.diagram.number.clear(); });
    explain("diagram usual");
    ImGui::SameLine(0, 8);
    if (ImGui::SmallButton(tr("fit"))) fitDiagram(context);
    explain("diagram fit");
}

// The diagram once the hand has done what it does: the left button sets the parameter, the right
// one drags the range, the wheel zooms.
Workspace::Diagram movedDiagram(StudioContext& context, ImVec2 low, ImVec2 space, bool hovered,
                                bool active) {
    const Workspace& workspace = context.workspace;
    Workspace::Diagram diagram = diagramOf(workspace);
    const ImGuiIO& io = ImGui::GetIO();
    const double unit = (diagram.right - diagram.left) / space.x;
    const auto valueAt = [&](float x) { return diagram.left + (x - low.x) * unit; };
    if (active && ImGui::IsMouseDown(0)) {
        const double value = valueAt(std::clamp(io.MousePos.x, low.x, low.x + space.x));
        if (value != sharedNumber(workspace, diagram.number)) {
            context.edit([&](Workspace& w) { setSharedNumber(w, diagram.number, value); });
            context.welcome = false;
            context.player.animation.running = false;
        }
    } else if (active && io.MouseDelta.x != 0) {
        diagram.left -= io.MouseDelta.x * unit;
        diagram.right -= io.MouseDelta.x * unit;
        keep(context, diagram);
    }
    if (hovered && io.MouseWheel != 0) {
        const double factor = std::pow(kWheel, static_cast<double>(io.MouseWheel));
        const double at = valueAt(io.MousePos.x);
        diagram.left = at + (diagram.left - at) * factor;
        diagram.right = at + (diagram.right - at) * factor;
        keep(context, diagram);
        diagram = diagramOf(workspace);
    }
    return diagram;
}

}  // namespace

void drawDiagram(StudioContext& context) {
    const Workspace& workspace = context.workspace;
    if (mapOf(workspace.views[0]).parameters == 0) {
        ImGui::TextDisabled("%s", tr("This map has no parameter to draw its attractor against."));
        return;
    }
    drawHead(context);
    const ImVec2 low = ImGui::GetCursorScreenPos(), space = ImGui::GetContentRegionAvail();
    if (space.x < 60 || space.y < 30) return;
    const float scale = ImGui::GetIO().DisplayFramebufferScale.x;
    const Size size{std::clamp(static_cast<int>(std::lround(space.x * scale)), 16, kMostColumns),
                    std::clamp(static_cast<int>(std::lround(space.y * scale)), 16, 800)};
    const ImVec2 high{low.x + space.x, low.y + space.y};
    ImGui::InvisibleButton("diagram", space,
                           ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonRight);
    const bool hovered = ImGui::IsItemHovered(), active = ImGui::IsItemActive();
    if (!active) explain("bifurcation diagram");
    const Workspace::Diagram diagram = movedDiagram(context, low, space, hovered, active);
    const double unit = (diagram.right - diagram.left) / space.x;
    const auto valueAt = [&](float x) { return diagram.left + (x - low.x) * unit; };
    DiagramStudy& study = studyDiagram(context, size);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled(low, high, ImGui::GetColorU32(ImGuiCol_FrameBg), 6);
    list.PushClipRect(low, high, true);
    if (!study.problem.empty())
        list.AddText({low.x + 8, low.y + 6}, ImGui::GetColorU32(ImGuiCol_Text),
                     trMessage(study.problem).c_str());
    put(context, study);
    if (study.texture && study.diagram) list.AddImage(textureId(study.texture), low, high);
    const double now = sharedNumber(workspace, diagram.number);
    const float line = low.x + static_cast<float>((now - diagram.left) / unit);
    const auto column = [&](float x) {
        return std::clamp(static_cast<int>((x - low.x) / space.x * static_cast<float>(size.width)),
                          0, size.width - 1);
    };
    const auto told = [&](float x) -> std::string {
        if (!study.diagram || column(x) >= study.filled) return {};
        return ",  " + periodText(study.diagram->periods[static_cast<std::size_t>(column(x))]);
    };
    if (line >= low.x && line <= high.x)
        list.AddLine({line, low.y}, {line, high.y}, ImGui::GetColorU32(ImGuiCol_CheckMark), 2);
    std::string text = diagram.number + " = " + shownNumber(now, 7) +
                       (line >= low.x && line <= high.x ? told(line) : tr(",  beyond this range"));
    drawText(list, {low.x + 8, low.y + 4}, IM_COL32(255, 222, 110, 255), text);
    if (hovered) {
        const float x = ImGui::GetIO().MousePos.x;
        list.AddLine({x, low.y}, {x, high.y}, ImGui::GetColorU32(ImGuiCol_TextDisabled, 0.8f), 1);
        text = shownNumber(valueAt(x), 7) + told(x);
        const float wide = ImGui::CalcTextSize(text.c_str()).x;
        drawText(list,
                 {std::min(x + 8, high.x - wide - 6), low.y + 4 + 1.5f * ImGui::GetFontSize()},
                 IM_COL32(231, 233, 238, 255), text);
    }
    if (study.diagram) {
        const MapInfo& info = mapOf(workspace.views[0]).info;
        const std::string state = stateComponent(info, study.options.component);
        text = tr("{1} from {2} to {3}",
                  {state, shownNumber(study.options.low, 4), shownNumber(study.options.high, 4)});
        drawText(list, {high.x - ImGui::CalcTextSize(text.c_str()).x - 8, low.y + 4},
                 IM_COL32(231, 233, 238, 255), text);
    }
    list.PopClipRect();
}

}  // namespace versorium
