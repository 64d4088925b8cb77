// SPDX-License-Identifier: MIT
#pragma once
// How the studio sets a value of the tables (scene/properties.h, workspace/workspace_properties.h):
// what the views share is set in all of them, what is a view's own in the focused one.

#include "scene/properties.h"
#include "workspace/workspace_properties.h"

namespace versorium {

struct StudioContext;

// The workspace is unchanged where it fails; the message says why, with the path and the range.
Status setValue(StudioContext& context, const SceneProperty& property, const Json& value);
Status setValue(StudioContext& context, const WorkspaceProperty& property, const Json& value);

// The path of a value by a name of older versions; any other name as it is.
std::string pathOfOldName(const std::string& name);
// Whether `name` means the value at `path`: its path, the last part of it, a name of older
// versions, or the group or list that it belongs to ("c" of "c.re", "roots" of "roots[1].re").
bool namesValue(std::string_view name, std::string_view path);

// Whether a name of a lesson or a link means this control: its own id, the parameter that it is a
// number of ("c" of "c.re"), the list that it belongs to ("roots" of "roots[1].re"), or "point" for
// the numbers of the starting point.
bool namesControl(const MapInfo& info, const std::string& name, const std::string& id);

}  // namespace versorium
