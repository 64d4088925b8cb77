// SPDX-License-Identifier: MIT
#include "workspace/diagram.h"

#include <algorithm>
#include <cmath>

#include "maps/critical.h"

namespace versorium {
Workspace::Diagram usualDiagram(const Workspace& workspace, const std::string& number) {
    Workspace::Diagram diagram{number, -2, 2};
    const MapInfo& info = mapOf(workspace.views[0]).info;
    int component = 0;
    for (const ParameterInfo& parameter : info.parameters)
        for (int k = 0; k < widthOf(parameter.kind); ++k, ++component)
            if (parameterComponent(info, component) == number) {
                diagram.left = std::max(parameter.low, -2.0);
                diagram.right = std::min(parameter.high, 4.0);
            }
    const auto own = workspace.ranges.find(number);
    if (own != workspace.ranges.end())
        diagram.left = own->second[0], diagram.right = own->second[1];
    if (!(diagram.left < diagram.right)) diagram.left = -2, diagram.right = 2;
    return diagram;
}

std::string diagramNumber(const Workspace& workspace) {
    const Scene& scene = workspace.views[0];
    const auto isParameter = [&](const std::string& name) {
        const auto number = numberNamed(scene, name);
        return number && number->kind == NumberKind::parameter;
    };
    if (isParameter(workspace.diagram.number)) return workspace.diagram.number;
    const int view = viewOfKind(workspace, ViewKind::parameters);
    if (view >= 0)
        for (const SliceAxis& axis : workspace.views[static_cast<std::size_t>(view)].slice.axes)
            for (const auto& [name, weight] : axis.terms)
                if (isParameter(name)) return name;
    return mapOf(scene).parameters > 0 ? parameterComponent(mapOf(scene).info, 0) : std::string();
}

Workspace::Diagram diagramOf(const Workspace& workspace) {
    const std::string number = diagramNumber(workspace);
    return workspace.diagram.number == number ? workspace.diagram : usualDiagram(workspace, number);
}

void setDiagramNumber(Workspace& workspace, const std::string& number) {
    workspace.diagram = usualDiagram(workspace, number);
}

// From a critical point every attracting cycle of a polynomial is found; a map of the plane starts
// where the orbit does.
Scene diagramScene(const Workspace& workspace) {
    Scene scene = orbitScene(workspace);
    const MapKernels& map = mapOf(scene);
    if (map.info.algebra != Algebra::plane && hasCriticalPoints(map)) scene.criticalStart = 0;
    return scene;
}

// The values between which the bounded orbits stay.
void fitDiagramHeight(const OrbitProgram& program, DiagramOptions& options) {
    constexpr int kColumns = 60, kSteps = 220, kTransient = 160;
    double low = INFINITY, high = -INFINITY;
    for (int k = 0; k < kColumns; ++k) {
        const double at[3] = {options.left + (options.right - options.left) * (k + 0.5) / kColumns,
                              0, 0};
        const auto orbit = orbitOf(program, at, kSteps);
        if (orbit.size() <= kSteps) continue;
        for (std::size_t n = kTransient; n < orbit.size(); ++n) {
            const double value = orbit[n][static_cast<std::size_t>(options.component)];
            if (!std::isfinite(value)) continue;
            low = std::min(low, value);
            high = std::max(high, value);
        }
    }
    if (!(low <= high)) low = -2, high = 2;
    const double margin = std::max(0.06 * (high - low), 1e-6 + 1e-6 * std::abs(high));
    options.low = low - margin;
    options.high = high + margin;
}

}  // namespace versorium
