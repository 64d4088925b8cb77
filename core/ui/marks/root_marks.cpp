// SPDX-License-Identifier: MIT
// Roots and poles on planes of starting points: a zero is a circle with its power, a pole a cross.
// They are dragged, raised by the wheel, added by a double click, and taken away by Delete or a
// menu. A root that does not lie in the plane is fainter and is moved along the plane's axes.
#include <algorithm>
#include <cmath>

#include "ui/marks/ring_mark.h"
#include "ui/session/root_edit.h"
#include "ui/session/state_plane.h"
#include "ui/widgets/help.h"
#include "ui/widgets/shown_number.h"

namespace versorium {
namespace {

constexpr ImU32 kRootHalo = IM_COL32(8, 10, 14, 210);
constexpr ImU32 kZero = IM_COL32(86, 180, 233, 255), kPole = IM_COL32(255, 140, 90, 255);
constexpr ImU32 kChosen = IM_COL32(255, 255, 255, 255);
constexpr float kRootReach = 11;
constexpr std::size_t kMostLabels = 40, kMostMarks = 600;
// Roots farther from the plane than this part of the view's height are fainter.
constexpr double kBeside = 0.01;

struct RootMark {
    RootRef ref;
    ImVec2 at;
    double exponent = 0, off = 0;
};

std::vector<RootMark> rootsOf(const ViewFrame& frame) {
    std::vector<RootMark> all;
    const Workspace& workspace = frame.workspace();
    const Scene& scene = frame.scene();
    if (!workspace.showRoots || !hasRoots(workspace)) return all;
    const std::optional<StatePlane> states = statePlaneOf(scene);
    if (!states) return all;
    for (const auto& [name, list] : scene.lists)
        for (std::size_t k = 0; k < list.roots.size() && all.size() < kMostMarks; ++k) {
            const RootRef ref{name, static_cast<int>(k)};
            const auto place = placeOfRoot(scene, list.roots[k]);
            const auto [u, v] = states->coordinates(place);
            all.push_back({ref, frame.plane.at(u, v), exponentOf(workspace, ref),
                           states->dimension > 2 ? states->distance(place) : 0});
        }
    return all;
}

// The item is the root's place in rootsOf().
std::optional<MarkHit> hitAmong(const ViewFrame& frame, const std::vector<RootMark>& roots) {
    std::optional<MarkHit> nearest;
    float reach = kRootReach * frame.scale();
    for (std::size_t k = 0; k < roots.size(); ++k) {
        const float away = frame.away(roots[k].at);
        // Of two at the same place the chosen one stays in the hand.
        const bool chosen = roots[k].ref == frame.context.versor.chosen;
        if (away > reach || (nearest && away == reach && !chosen)) continue;
        reach = away;
        nearest = MarkHit{static_cast<int>(k), away};
    }
    return nearest;
}

std::optional<RootMark> rootAtPointer(const ViewFrame& frame) {
    const std::vector<RootMark> roots = rootsOf(frame);
    const std::optional<MarkHit> hit = hitAmong(frame, roots);
    if (!hit) return std::nullopt;
    return roots[static_cast<std::size_t>(hit->item)];
}

std::optional<MarkHit> hitRoot(const ViewFrame& frame) { return hitAmong(frame, rootsOf(frame)); }

ImU32 faded(ImU32 colour, double part) {
    const auto alpha = static_cast<ImU32>(part * ((colour >> IM_COL32_A_SHIFT) & 0xffu));
    return (colour & ~IM_COL32_A_MASK) | (alpha << IM_COL32_A_SHIFT);
}

void drawRoot(ImDrawList& list, const RootMark& mark, float size, double part) {
    const ImVec2 at = mark.at;
    const bool pole = mark.exponent < 0;
    // The line stays brighter than its halo does.
    const ImU32 halo = faded(kRootHalo, part * part),
                tint = faded(pole ? kPole : kZero, std::sqrt(part));
    for (const auto& [colour, width] :
         {std::pair{halo, 0.8f * size}, std::pair{tint, 0.35f * size}})
        if (pole) {
            list.AddLine({at.x - size, at.y - size}, {at.x + size, at.y + size}, colour, width);
            list.AddLine({at.x - size, at.y + size}, {at.x + size, at.y - size}, colour, width);
        } else {
            list.AddCircle(at, size, colour, 16, width);
        }
}

// "roots[2] = 0.45 + 0.3 i, power 1".
std::string labelOf(const Workspace& workspace, const RootMark& mark, double pixel) {
    const Scene& scene = workspace.views[0];
    const RootList::Root& root = rootAt(workspace, mark.ref);
    constexpr const char* kUnits[] = {"", " i", " j", " k"};
    const int width = dimensionOf(mapOf(scene).info.algebra);
    const int digits =
        std::clamp(static_cast<int>(std::ceil(-std::log10(std::max(pixel, 1e-15)))), 1, 15);
    const double unit = std::pow(10.0, digits);
    std::string text = mark.ref.list + "[" + std::to_string(mark.ref.item) + "] = ";
    for (int k = 0; k < width; ++k) {
        const double part = std::round(root.q[static_cast<std::size_t>(k)] * unit) / unit;
        if (k > 0 && part == 0 && width > 2) continue;
        if (k > 0) text += part < 0 ? " − " : " + ";
        text += shownNumber(k > 0 ? std::abs(part) : part, 6) + kUnits[k];
    }
    text += tr(", power {1}", {shownNumber(root.power, 4)});
    if (mark.off > 0) text += tr(", {1} beside this plane", {shownNumber(mark.off, 2)});
    return text;
}

bool hovers(const ViewFrame& frame) {
    const ViewPlane& plane = frame.plane;
    const ScreenPoint mouse = frame.pointer.at;
    return mouse.x >= plane.low.x && mouse.x < plane.high.x && mouse.y >= plane.low.y &&
           mouse.y < plane.high.y && !frame.context.dialogOpen();
}

void drawLabel(const ViewFrame& frame, const RootMark& root) {
    const ViewPlane& plane = frame.plane;
    const float scale = frame.scale();
    const std::string label = labelOf(frame.workspace(), root, plane.place.pixel());
    const float wide = ImGui::CalcTextSize(label.c_str()).x;
    drawText(frame.list(),
             {std::clamp(root.at.x + 13 * scale, plane.low.x + 4,
                         std::max(plane.low.x + 4, plane.high.x - wide - 6)),
              std::min(root.at.y + 9 * scale, plane.high.y - 24 * scale)},
             kChosen, label);
}

void drawRootMarks(const ViewFrame& frame) {
    const std::vector<RootMark> roots = rootsOf(frame);
    const float scale = frame.scale();
    const bool few = roots.size() <= kMostLabels;
    const Drag& drag = frame.state().drag;
    const bool dragged = drag.mark == &rootMark;
    // What its numbers are told of: the one under the pointer, else the chosen one.
    std::optional<RootMark> told;
    if (drag.idle() && hovers(frame))
        if (const auto hit = hitAmong(frame, roots))
            told = roots[static_cast<std::size_t>(hit->item)];
    for (const RootMark& root : roots) {
        const bool chosen = root.ref == frame.context.versor.chosen;
        const double part = root.off > kBeside * frame.plane.place.height ? 0.55 : 1;
        drawRoot(frame.list(), root, (few ? 5.5f : 3.5f) * scale, part);
        if (chosen) frame.list().AddCircle(root.at, 10 * scale, kChosen, 0, 1.5f * scale);
        if (chosen && (dragged || !told)) told = root;
        if (few && std::abs(root.exponent) != 1)
            drawText(frame.list(), {root.at.x + 7 * scale, root.at.y - 16 * scale},
                     faded(root.exponent < 0 ? kPole : kZero, part),
                     shownNumber(std::abs(root.exponent), 3));
    }
    if (told) drawLabel(frame, *told);
}

// The chosen root goes to the pointer and beside it, by as much as when it was taken.
void dragRoot(const ViewFrame& frame, const std::array<double, 2>& grab) {
    const RootRef& ref = frame.context.versor.chosen;
    if (!isRoot(frame.workspace(), ref)) return;
    const Scene& scene = frame.scene();
    const std::optional<StatePlane> states = statePlaneOf(scene);
    if (!states) return;
    RootList::Root root = rootAt(frame.workspace(), ref);
    const auto before = states->coordinates(placeOfRoot(scene, root));
    const double du = frame.u() + grab[0] - before[0], dv = frame.v() + grab[1] - before[1];
    for (std::size_t k = 0; k < 4; ++k)
        root.q[k] += du * states->axis[0][k] + dv * states->axis[1][k];
    frame.context.edit([&](Workspace& workspace) { setRoot(workspace, ref, root); });
}

std::optional<Drag> pressRoot(const ViewFrame& frame) {
    if (frame.pointer.modified()) return std::nullopt;
    const std::vector<RootMark> roots = rootsOf(frame);
    const std::optional<MarkHit> hit = hitAmong(frame, roots);
    RootRef& chosen = frame.context.versor.chosen;
    if (!hit) {
        chosen = {};
        return std::nullopt;
    }
    const RootMark& root = roots[static_cast<std::size_t>(hit->item)];
    chosen = root.ref;
    if (onRing(frame)) return std::nullopt;
    const std::array<double, 2> grab{frame.plane.u(root.at.x) - frame.u(),
                                     frame.plane.v(root.at.y) - frame.v()};
    return Drag{.mark = &rootMark, .item = hit->item, .move = [grab](const ViewFrame& now) {
                    dragRoot(now, grab);
                }};
}

// A step of 1, or with Shift of 0.1.
bool raiseRoot(const ViewFrame& frame, float steps) {
    const std::optional<RootMark> root = rootAtPointer(frame);
    if (!root) return false;
    VersorState& versor = frame.context.versor;
    versor.chosen = root->ref;
    // Fine wheels turn by parts of a step.
    versor.turned += static_cast<double>(steps);
    const double whole = std::trunc(versor.turned);
    versor.turned -= whole;
    if (whole == 0) return true;
    const double power =
        rootAt(frame.workspace(), root->ref).power + whole * (frame.pointer.shift ? 0.1 : 1);
    // Tenths stay tenths.
    setRootPower(frame.context, root->ref, std::round(power * 1e6) / 1e6);
    return true;
}

// Makes a root where none is; not beside the ring.
bool makeRoot(const ViewFrame& frame) {
    const std::optional<StatePlane> states = statePlaneOf(frame.scene());
    if (!states || !frame.workspace().showRoots || !hasRoots(frame.workspace()) ||
        ringMark.hit(frame))
        return false;
    if (!hitRoot(frame)) addRootAtPlace(frame.context, {}, states->at(frame.u(), frame.v()));
    return true;
}

bool openRootMenu(const ViewFrame& frame) {
    const std::optional<RootMark> root = rootAtPointer(frame);
    if (!root) return false;
    frame.context.versor.chosen = root->ref;
    ImGui::OpenPopup("root");
    return true;
}

void drawRootMenu(const ViewFrame& frame) {
    if (!ImGui::BeginPopup("root")) return;
    StudioContext& context = frame.context;
    const RootRef ref = context.versor.chosen;
    if (!isRoot(context.workspace, ref)) {
        ImGui::CloseCurrentPopup();
        return ImGui::EndPopup();
    }
    ImGui::TextDisabled("%s[%d]", ref.list.c_str(), ref.item);
    double power = rootAt(context.workspace, ref).power;
    ImGui::SetNextItemWidth(90 * context.scale);
    if (dragNumber(tr("power"), power, 0.02, "%.6g")) setRootPower(context, ref, power);
    explain("root power");
    if (ImGui::MenuItem(exponentOf(context.workspace, ref) < 0 ? tr("Make it a zero")
                                                               : tr("Make it a pole")))
        turnChosenRoot(context);
    if (ImGui::MenuItem(tr("Take it away"), tr("Delete"))) removeChosenRoot(context);
    ImGui::EndPopup();
}

// "roots[2]".
std::string nameOfRoot(const ViewFrame& frame, int item) {
    const std::vector<RootMark> roots = rootsOf(frame);
    if (item >= static_cast<int>(roots.size())) return {};
    const RootRef& ref = roots[static_cast<std::size_t>(item)].ref;
    return ref.list + "[" + std::to_string(ref.item) + "]";
}

}  // namespace

const Mark rootMark{
    .name = nameOfRoot,
    .draw = drawRootMarks,
    .hit = hitRoot,
    .press = pressRoot,
    .wheel = raiseRoot,
    .doubleClick = makeRoot,
    .openMenu = openRootMenu,
    .drawMenu = drawRootMenu,
};

}  // namespace versorium
