// SPDX-License-Identifier: MIT
#pragma once
// A view of the studio beside its scene: where it lies in the window, what it wants drawn, the
// picture of that as it comes, where it has been, and what the hand is doing there.

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "scene/scene.h"
#include "ui/session/live_picture.h"
#include "ui/session/motion.h"
#include "ui/session/screen.h"

namespace versorium {

struct Mark;       // ui/marks/mark.h
struct ViewFrame;  // ui/marks/view_frame.h

// What a press has begun, until the button is up: a mark follows the pointer, or the view does.
// Only who began it knows what it is; the view calls it.
struct Drag {
    const Mark* mark = nullptr;  // that is dragged, and which of its kind; null: it is the view
    int item = 0;
    std::function<void(const ViewFrame&)> move{};     // the pointer has moved
    std::function<void(const ViewFrame&)> release{};  // the button is up
    std::function<void(const ViewFrame&)> draw{};     // over everything else
    bool fingers = false;                             // two of them move the view

    bool idle() const { return !mark && !move && !release && !fingers; }
};

// The places that a view has shown, for back and forward.
struct ViewHistory {
    std::vector<SliceSpec> places;
    std::size_t at = 0;
};

// What a view wants drawn, made anew when the revision or the view's shape is.
struct WantedPicture {
    std::uint64_t revision = 0;
    double aspect = 0;
    Scene scene;
    std::string key, orbits;  // LiveScene's
};

struct ViewState {
    ScreenPoint low, high;  // its rectangle in the window; empty where it is not drawn
    WantedPicture wanted;
    LivePicture picture;
    ViewHistory history;
    std::optional<Glide> glide;  // on its way; the workspace holds where it is now
    Drag drag;
    double pinchedAt = -100;  // when two fingers moved it last
};

}  // namespace versorium
