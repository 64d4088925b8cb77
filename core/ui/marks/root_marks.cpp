// SPDX-License-Identifier: MIT
#include "ui/marks/root_marks.h"

#include <algorithm>
#include <cmath>

#include "ui/session/state_plane.h"
#include "ui/widgets/help.h"
#include "ui/widgets/number_field.h"

namespace versorium {
namespace {

constexpr ImU32 kHalo = IM_COL32(8, 10, 14, 210);
constexpr ImU32 kZero = IM_COL32(86, 180, 233, 255), kPole = IM_COL32(255, 140, 90, 255);
constexpr ImU32 kWhite = IM_COL32(255, 255, 255, 255);
constexpr float kReach = 11;
constexpr std::size_t kMostLabels = 40, kMostMarks = 600;
// Roots farther from the plane than this part of the view's height are fainter.
constexpr double kBeside = 0.01;

struct Mark {
    RootRef ref;
    ImVec2 at;
    double exponent = 0, off = 0;
};

std::vector<Mark> marksOf(const StudioContext& context, int view, const ViewPlane& plane) {
    std::vector<Mark> all;
    const Workspace& workspace = context.workspace;
    const Scene& scene = workspace.views[static_cast<std::size_t>(view)];
    if (!workspace.showRoots || !hasRoots(workspace)) return all;
    const std::optional<StatePlane> states = statePlaneOf(scene);
    if (!states) return all;
    for (const auto& [name, list] : scene.lists)
        for (std::size_t k = 0; k < list.roots.size() && all.size() < kMostMarks; ++k) {
            const RootRef ref{name, static_cast<int>(k)};
            const auto place = placeOfRoot(scene, list.roots[k]);
            const auto [u, v] = states->coordinates(place);
            all.push_back({ref, plane.at(u, v), exponentOf(workspace, ref),
                           states->dimension > 2 ? states->distance(place) : 0});
        }
    return all;
}

std::optional<Mark> markNear(const StudioContext& context, int view, const ViewPlane& plane,
                             ImVec2 mouse) {
    std::optional<Mark> nearest;
    float reach = kReach * context.scale;
    for (const Mark& mark : marksOf(context, view, plane)) {
        const float away = std::hypot(mark.at.x - mouse.x, mark.at.y - mouse.y);
        // Of two at the same place the chosen one stays in the hand.
        if (away > reach || (nearest && away == reach && !(mark.ref == context.versor.chosen)))
            continue;
        reach = away;
        nearest = mark;
    }
    return nearest;
}

ImU32 faded(ImU32 colour, double part) {
    const auto alpha = static_cast<ImU32>(part * ((colour >> IM_COL32_A_SHIFT) & 0xffu));
    return (colour & ~IM_COL32_A_MASK) | (alpha << IM_COL32_A_SHIFT);
}

void drawOne(ImDrawList& list, const Mark& mark, float size, double part) {
    const ImVec2 at = mark.at;
    const bool pole = mark.exponent < 0;
    // The line stays brighter than its halo does.
    const ImU32 halo = faded(kHalo, part * part),
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
std::string labelOf(const Workspace& workspace, const Mark& mark, double pixel) {
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

bool hoversView(const StudioContext& context, int view) {
    const ViewState& state = context.views[static_cast<std::size_t>(view)];
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    return mouse.x >= state.low.x && mouse.x < state.high.x && mouse.y >= state.low.y &&
           mouse.y < state.high.y && !context.dialogOpen();
}

void add(StudioContext& context, const std::string& list, const std::array<double, 4>& place) {
    const Scene& scene = context.workspace.views[context.workspace.speaker()];
    const auto made = addRoot(context.workspace, list, {rootOfPlace(scene, place), 1});
    if (!made) return context.report(made.status());
    context.versor.chosen = *made;
    context.touch();
}

void setPower(StudioContext& context, const RootRef& ref, double power) {
    RootList::Root root = rootAt(context.workspace, ref);
    root.power = std::clamp(power, -kLargestRootPower, kLargestRootPower);
    setRoot(context.workspace, ref, root);
    context.touch();
}

}  // namespace

void drawRootMarks(StudioContext& context, int view, const ViewPlane& plane, ImDrawList& list) {
    const std::vector<Mark> marks = marksOf(context, view, plane);
    const float scale = context.scale;
    const bool few = marks.size() <= kMostLabels;
    const ViewState& state = context.views[static_cast<std::size_t>(view)];
    const bool dragged = state.drag == ViewState::Drag::root;
    std::optional<Mark> told;
    if (!dragged && state.drag == ViewState::Drag::none && hoversView(context, view))
        told = markNear(context, view, plane, ImGui::GetIO().MousePos);
    for (const Mark& mark : marks) {
        const bool chosen = mark.ref == context.versor.chosen;
        const double part = mark.off > kBeside * plane.place.height ? 0.55 : 1;
        drawOne(list, mark, (few ? 5.5f : 3.5f) * scale, part);
        if (chosen) list.AddCircle(mark.at, 10 * scale, kWhite, 0, 1.5f * scale);
        if (chosen && (dragged || !told)) told = mark;
        if (few && std::abs(mark.exponent) != 1)
            drawText(list, {mark.at.x + 7 * scale, mark.at.y - 16 * scale},
                     faded(mark.exponent < 0 ? kPole : kZero, part),
                     shownNumber(std::abs(mark.exponent), 3));
    }
    if (!told) return;
    const std::string label = labelOf(context.workspace, *told, plane.place.pixel());
    const float wide = ImGui::CalcTextSize(label.c_str()).x;
    drawText(list,
             {std::clamp(told->at.x + 13 * scale, plane.low.x + 4,
                         std::max(plane.low.x + 4, plane.high.x - wide - 6)),
              std::min(told->at.y + 9 * scale, plane.high.y - 24 * scale)},
             kWhite, label);
}

bool takeRootMark(StudioContext& context, int view, const ViewPlane& plane, ImVec2 mouse) {
    const std::optional<Mark> mark = markNear(context, view, plane, mouse);
    context.versor.chosen = mark ? mark->ref : RootRef{};
    if (!mark) return false;
    // The orbit's own ring lies on top.
    const auto ring = markerOf(context.workspace, static_cast<std::size_t>(view));
    const ImVec2 at = plane.at(ring[0], ring[1]);
    if (std::hypot(at.x - mouse.x, at.y - mouse.y) <= 9 * context.scale) return false;
    context.versor.grab = {plane.u(mark->at.x) - plane.u(mouse.x),
                           plane.v(mark->at.y) - plane.v(mouse.y)};
    context.views[static_cast<std::size_t>(view)].drag = ViewState::Drag::root;
    return true;
}

void dragRootMark(StudioContext& context, int view, const ViewPlane& plane, ImVec2 mouse) {
    Workspace& workspace = context.workspace;
    const RootRef& ref = context.versor.chosen;
    if (context.views[static_cast<std::size_t>(view)].drag != ViewState::Drag::root ||
        !isRoot(workspace, ref))
        return;
    const Scene& scene = workspace.views[static_cast<std::size_t>(view)];
    const std::optional<StatePlane> states = statePlaneOf(scene);
    if (!states) return;
    RootList::Root root = rootAt(workspace, ref);
    const std::array<double, 4> place = placeOfRoot(scene, root);
    const auto before = states->coordinates(place);
    const double du = plane.u(mouse.x) + context.versor.grab[0] - before[0];
    const double dv = plane.v(mouse.y) + context.versor.grab[1] - before[1];
    for (std::size_t k = 0; k < 4; ++k)
        root.q[k] += du * states->axis[0][k] + dv * states->axis[1][k];
    setRoot(workspace, ref, root);
    context.touch();
}

bool openRootMenu(StudioContext& context, int view, const ViewPlane& plane, ImVec2 mouse) {
    const std::optional<Mark> mark = markNear(context, view, plane, mouse);
    if (!mark) return false;
    context.versor.chosen = mark->ref;
    ImGui::OpenPopup("root");
    return true;
}

void drawRootMenu(StudioContext& context) {
    if (!ImGui::BeginPopup("root")) return;
    const RootRef ref = context.versor.chosen;
    if (!isRoot(context.workspace, ref)) {
        ImGui::CloseCurrentPopup();
        return ImGui::EndPopup();
    }
    ImGui::TextDisabled("%s[%d]", ref.list.c_str(), ref.item);
    double power = rootAt(context.workspace, ref).power;
    if (numberCell(context, tr("power"), power,
                   {.help = helpOf("root power"), .low = -4, .high = 8}, 150 * context.scale))
        setPower(context, ref, power);
    if (ImGui::MenuItem(exponentOf(context.workspace, ref) < 0 ? tr("Make it a zero")
                                                               : tr("Make it a pole"))) {
        const Expected<RootRef> turned = turnRoot(context.workspace, ref);
        if (turned) context.versor.chosen = *turned, context.touch();
        context.report(turned ? Status() : turned.status());
    }
    if (ImGui::MenuItem(tr("Take it away"), tr("Delete"))) removeChosenRoot(context);
    ImGui::EndPopup();
}

bool raiseRoot(StudioContext& context, int view, const ViewPlane& plane, ImVec2 mouse, float wheel,
               bool fine) {
    const std::optional<Mark> mark = markNear(context, view, plane, mouse);
    if (!mark) return false;
    context.versor.chosen = mark->ref;
    // Fine wheels turn by parts of a step.
    context.versor.turned += static_cast<double>(wheel);
    const double steps = std::trunc(context.versor.turned);
    context.versor.turned -= steps;
    if (steps == 0) return true;
    const double power = rootAt(context.workspace, mark->ref).power + steps * (fine ? 0.1 : 1);
    // Tenths stay tenths.
    setPower(context, mark->ref, std::round(power * 1e6) / 1e6);
    return true;
}

bool addRootAt(StudioContext& context, int view, const ViewPlane& plane, ImVec2 mouse) {
    const Scene& scene = context.workspace.views[static_cast<std::size_t>(view)];
    const std::optional<StatePlane> states = statePlaneOf(scene);
    if (!states || !context.workspace.showRoots || !hasRoots(context.workspace)) return false;
    if (!markNear(context, view, plane, mouse))
        add(context, drawnList(context.workspace), states->at(plane.u(mouse.x), plane.v(mouse.y)));
    return true;
}

void addRootAtPoint(StudioContext& context, const std::string& list) {
    if (!hasRoots(context.workspace)) return context.say("This map has no roots");
    std::array<double, 4> place{};
    std::copy_n(context.workspace.point.begin(),
                std::min<std::size_t>(4, context.workspace.point.size()), place.begin());
    add(context, list.empty() ? drawnList(context.workspace) : list, place);
}

void removeChosenRoot(StudioContext& context) {
    if (!isRoot(context.workspace, context.versor.chosen))
        return context.say("Choose a root first: click it in a view of starting points");
    const Status status = removeRoot(context.workspace, context.versor.chosen);
    if (!status.ok()) return context.report(status);
    context.versor.chosen = {};
    context.touch();
}

}  // namespace versorium
