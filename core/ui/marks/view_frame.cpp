// SPDX-License-Identifier: MIT
#include "ui/marks/view_frame.h"

#include <cmath>

namespace versorium {

float ViewFrame::away(const ScreenPoint& place) const {
    return std::hypot(place.x - pointer.at.x, place.y - pointer.at.y);
}

bool ViewFrame::spoken() const {
    return !workspace().analysis() || view == static_cast<int>(workspace().speaker());
}

ViewFrame frameOf(StudioContext& context, int view, Size size, const Pointer& pointer) {
    const auto index = static_cast<std::size_t>(view);
    const Scene& scene = context.workspace.views[index];
    Viewport place = viewportOf(scene, size);
    place.height = shownHeight(scene, static_cast<double>(size.width) / size.height);
    const ViewPlane plane{context.views[index].low, context.views[index].high, place};
    const auto point = markerOf(context.workspace, index);
    return {context, view, plane, pointer, plane.at(point[0], point[1])};
}

}  // namespace versorium
