// SPDX-License-Identifier: MIT
#include "ui/session/space_view.h"

#include <glm/geometric.hpp>

#include "ui/session/context.h"

namespace versorium {

std::optional<PlaneInSpace> markedPlane(StudioContext& context) {
    const Scene& scene = context.workspace.view();
    if (!mapOf(scene).info.field || !traitsOf(scene).shape) return std::nullopt;
    const OrbitProgram* program = context.bound.program(context.workspace.focused);
    if (!program || !program->field) return std::nullopt;
    return planeInSpace(scene, *program);
}

void putPlane(StudioContext& context, const PlaneInSpace& plane) {
    context.edit([&](Workspace& workspace) { setPlane(workspace.view(), plane); });
}

double planeOffset(const PlaneInSpace& plane) { return glm::dot(plane.origin, plane.normal()); }

}  // namespace versorium
