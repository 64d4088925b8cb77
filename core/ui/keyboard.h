// SPDX-License-Identifier: MIT
#pragma once
// The keys of the studio.

namespace versorium {

struct StudioContext;

// Runs what is pressed in this frame.
void handleKeys(StudioContext& context);

}  // namespace versorium
