// SPDX-License-Identifier: MIT
#pragma once
// The text of lessons in ImGui: paragraphs, lists and emphasis, wrapped to the room there is.

#include <string>
#include <vector>

#include "lesson/markdown.h"

namespace versorium {

void drawProse(const std::vector<MarkdownBlock>& blocks);
// One paragraph without emphasis.
void drawParagraph(const std::string& text);

}  // namespace versorium
