// SPDX-License-Identifier: MIT
#pragma once
// Folder marks: all that lies on the picture of a view. A mark is drawn there and follows the hand:
// the ring, roots, circles, pins, corners of an outline; what is only drawn, such as the orbit, is
// a mark that no hand takes. Each kind is one file and one line of the table in all_marks.cpp. The
// folder knows the session, widgets and textures; of views, plots and panels it knows nothing, and
// no kind of mark knows another, but that the ring lies on top of all (ring_mark.h).
//
// Marks change the workspace by StudioContext::edit and read the pointer from the frame, so that
// only what draws needs ImGui.

#include <optional>
#include <span>
#include <string>

#include "ui/marks/view_frame.h"

namespace versorium {

// The one of its kind that is under the pointer, or near enough.
struct MarkHit {
    int item = 0;
    float distance = 0;  // from the pointer, in pixels
};

// One kind of mark. Functions that a kind has no use for are null.
struct Mark {
    // What one of them is called, as it is said to those who do not see it.
    std::string (*name)(const ViewFrame& frame, int item) = nullptr;
    void (*draw)(const ViewFrame& frame) = nullptr;
    std::optional<MarkHit> (*hit)(const ViewFrame& frame) = nullptr;

    // The left button went down: what follows the pointer from now on; an idle drag where the press
    // itself was all; nothing where it was not for this mark.
    std::optional<Drag> (*press)(const ViewFrame& frame) = nullptr;
    // The view that such a press marks, where that is not the one it was made in.
    std::optional<int> (*focus)(const ViewFrame& frame) = nullptr;
    // True where the wheel, the double click, or the right button was for this mark.
    bool (*wheel)(const ViewFrame& frame, float steps) = nullptr;
    bool (*doubleClick)(const ViewFrame& frame) = nullptr;
    bool (*openMenu)(const ViewFrame& frame) = nullptr;
    void (*drawMenu)(const ViewFrame& frame) = nullptr;
    // A tool in the hand has the pointer to itself, whatever lies under it: true where it took it.
    bool (*tool)(const ViewFrame& frame) = nullptr;
};

// The kinds, each in a file of its own.
extern const Mark arrowMark, circleCentreMark, circleRadiusMark, comparedMark, drawingMark,
    lessonMark, orbitMark, pinMark, placeMark, ringMark, rootMark, startMark, studyMark;

// All of them, in the order in which the hand takes them.
std::span<const Mark* const> marksByHand();
// The same from the lowest to the one that is drawn over all others.
std::span<const Mark* const> marksByHeight();

}  // namespace versorium
