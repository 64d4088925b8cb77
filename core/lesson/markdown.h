// SPDX-License-Identifier: MIT
#pragma once
// The Markdown that lessons are written in: headings, paragraphs, lists, emphasis, strong emphasis,
// code spans, and fenced blocks, whose text is left to the lesson. Foreign input: no HTML, no
// images, no links, no tables; what is not known is refused with its line.

#include <string>
#include <string_view>
#include <vector>

#include "base/status.h"

namespace versorium {

inline constexpr std::size_t kMarkdownBytes = 256u << 10;
inline constexpr std::size_t kMarkdownBlocks = 4000;
inline constexpr int kMarkdownDepth = 4;  // of lists in each other

struct TextRun {
    std::string text;  // UTF-8
    bool strong = false, emphasis = false, code = false;
    friend bool operator==(const TextRun&, const TextRun&) = default;
};

struct MarkdownBlock {
    enum class Kind { heading, paragraph, item, fence };
    Kind kind = Kind::paragraph;
    int line = 0;    // in the file, from 1; 0 where that is not known
    int level = 0;   // of a heading from 1; of a list's item from 1
    int number = 0;  // of an item of a numbered list from 1, else 0
    std::vector<TextRun> runs = {};
    std::string info = {}, text = {};  // of a fence: the words behind ```, and its lines
    friend bool operator==(const MarkdownBlock&, const MarkdownBlock&) = default;
};

// `firstLine` is the line of the file at which `text` begins.
Expected<std::vector<MarkdownBlock>> parseMarkdown(std::string_view text, int firstLine = 1);

// The words alone.
std::string plainText(const MarkdownBlock& block);
std::string plainText(const std::vector<MarkdownBlock>& blocks);

}  // namespace versorium
