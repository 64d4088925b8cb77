// SPDX-License-Identifier: MIT
#pragma once
// The one table of a workspace's own values, beside its views: what is drawn of the orbit,
// overlays, the plot panel (scene/property.h says what a property is).

#include "scene/property.h"
#include "workspace/workspace.h"

namespace versorium {

using WorkspaceProperty = Property<Workspace>;

// In the order of the JSON. Setting one needs the views, which stand already.
const PropertyTable<Workspace>& workspaceTable();
// Every value that applies, with the parts of groups: "study.cycles", "circles[0].radius".
PropertyTable<Workspace> propertiesOf(const Workspace& workspace);
std::optional<WorkspaceProperty> propertyNamed(const Workspace& workspace, const std::string& path);

}  // namespace versorium
