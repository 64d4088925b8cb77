// SPDX-License-Identifier: MIT
#pragma once
// The bifurcation diagram of a workspace: over which parameter it runs, and what it shows.

#include <string>

#include "dynamics/bifurcation_diagram.h"
#include "workspace/workspace.h"

namespace versorium {

// The parameter that the diagram runs over.
std::string diagramNumber(const Workspace& workspace);
// Its number with a range: that of the number itself where it has none yet.
Workspace::Diagram diagramOf(const Workspace& workspace);
void setDiagramNumber(Workspace& workspace, const std::string& number);
// Over the number's own range.
Workspace::Diagram usualDiagram(const Workspace& workspace, const std::string& number);

// The scene whose orbits it shows.
Scene diagramScene(const Workspace& workspace);
// Sets low and high to the values between which the bounded orbits of options.component stay.
void fitDiagramHeight(const OrbitProgram& program, DiagramOptions& options);

}  // namespace versorium
