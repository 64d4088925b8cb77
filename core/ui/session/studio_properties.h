// SPDX-License-Identifier: MIT
#pragma once
// The table of the studio's own values, beside those of the scene and the workspace: colours and
// language of the interface, who draws, exports, the brush, roots at random, players. They are no
// part of what is open: undo, links and files know nothing of them.

#include <string_view>

#include "scene/property.h"

namespace versorium {

struct StudioContext;
using StudioProperty = Property<StudioContext>;

const PropertyTable<StudioContext>& studioProperties();
const StudioProperty* studioPropertyNamed(std::string_view path);  // null where there is none

}  // namespace versorium
