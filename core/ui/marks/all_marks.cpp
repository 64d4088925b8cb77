// SPDX-License-Identifier: MIT
// The table of all kinds of marks.
#include <algorithm>
#include <array>
#include <iterator>

#include "ui/marks/mark.h"

namespace versorium {

namespace {

struct Entry {
    const Mark& mark;
    int height;  // marks of a greater height are drawn over those of a lesser one
};

// The hand takes the first one of this table that is under it.
const Entry kMarks[] = {
    {drawingMark, 60},       // a tool in the hand
    {pinMark, 10},           // Shift
    {rootMark, 70},          //
    {circleRadiusMark, 10},  // with the circles and what becomes of them
    {circleCentreMark, 11},  //
    {startMark, 51},         // p*
    {comparedMark, 50},      // the second start
    {placeMark, 90},         // of an analysis, in its first view
    {ringMark, 91},          // the workspace's point
    // What is only drawn.
    {arrowMark, 20},
    {orbitMark, 30},
    {studyMark, 40},
    {lessonMark, 80},
};
using Marks = std::array<const Mark*, std::size(kMarks)>;

Marks sortedMarks(bool byHeight) {
    std::array<Entry const*, std::size(kMarks)> entries;
    for (std::size_t k = 0; k < entries.size(); ++k) entries[k] = &kMarks[k];
    if (byHeight)
        std::stable_sort(entries.begin(), entries.end(),
                         [](const Entry* a, const Entry* b) { return a->height < b->height; });
    Marks marks;
    std::transform(entries.begin(), entries.end(), marks.begin(),
                   [](const Entry* entry) { return &entry->mark; });
    return marks;
}

}  // namespace

std::span<const Mark* const> marksByHand() {
    static const Marks marks = sortedMarks(false);
    return marks;
}

std::span<const Mark* const> marksByHeight() {
    static const Marks marks = sortedMarks(true);
    return marks;
}

}  // namespace versorium
