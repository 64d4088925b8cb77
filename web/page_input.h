// SPDX-License-Identifier: MIT
#pragma once
// What the hands do, for Dear ImGui. page/input.mjs listens to the browser and calls the functions
// of page_input.cpp; positions are pixels of the canvas.

namespace versorium {

// True once after something came in; the page then draws some frames, for ImGui spreads events that
// lie close together over several.
bool takeInput();

}  // namespace versorium
