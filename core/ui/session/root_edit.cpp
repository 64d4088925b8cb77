// SPDX-License-Identifier: MIT
#include "ui/session/root_edit.h"

#include <algorithm>

#include "ui/session/context.h"

namespace versorium {

void addRootAtPlace(StudioContext& context, const std::string& list,
                    const std::array<double, 4>& place) {
    const Expected<RootRef> made = context.edit([&](Workspace& workspace) {
        const Scene& scene = workspace.views[workspace.speaker()];
        return addRoot(workspace, list.empty() ? drawnList(workspace) : list,
                       {rootOfPlace(scene, place), 1});
    });
    if (!made) return context.report(made.status());
    context.versor.chosen = *made;
}

void addRootAtPoint(StudioContext& context, const std::string& list) {
    if (!hasRoots(context.workspace)) return context.say("This map has no roots");
    const std::vector<double>& point = context.workspace.point;
    std::array<double, 4> place{};
    std::copy_n(point.begin(), std::min<std::size_t>(4, point.size()), place.begin());
    addRootAtPlace(context, list, place);
}

void setRootPower(StudioContext& context, const RootRef& ref, double power) {
    context.edit([&](Workspace& workspace) {
        RootList::Root root = rootAt(workspace, ref);
        root.power = std::clamp(power, -kLargestRootPower, kLargestRootPower);
        setRoot(workspace, ref, root);
    });
}

void turnChosenRoot(StudioContext& context) {
    const Expected<RootRef> turned = context.edit(
        [&](Workspace& workspace) { return turnRoot(workspace, context.versor.chosen); });
    if (!turned) return context.report(turned.status());
    context.versor.chosen = *turned;
}

void removeChosenRoot(StudioContext& context) {
    if (!isRoot(context.workspace, context.versor.chosen))
        return context.say("Choose a root first: click it in a view of starting points");
    const Status status = context.edit(
        [&](Workspace& workspace) { return removeRoot(workspace, context.versor.chosen); });
    if (!status.ok()) return context.report(status);
    context.versor.chosen = {};
}

}  // namespace versorium
