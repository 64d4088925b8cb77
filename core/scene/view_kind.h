// SPDX-License-Identifier: MIT
#pragma once
// What a view shows: settings of the parameters, or starting points at one setting. Both are slices
// of the same space (view/slice.h); only what a hand expects of them differs. Each difference is
// said here, once. What has two sides to it is a function beside the values that it changes, with a
// `switch` over all kinds (workspace/workspace.h): a compiler that finds a kind missing refuses it.

#include "base/words.h"
#include "scene/scene.h"

namespace versorium {

// In the order in which they stand side by side.
enum class ViewKind { parameters, startingPoints };
template <>
struct EnumWords<ViewKind> {
    static constexpr std::array<std::string_view, 2> table{"parameters", "starts"};
};

// Parameters as soon as an axis of the slice is a parameter or part of a root.
ViewKind viewKind(const Scene& scene);

struct ViewTraits {
    const char *title, *tab;  // in English
    // For who does not see it: number of the view, map, height, middle, place of the ring.
    const char* spoken;
    // What lies in it.
    bool orbit;    // the orbit of the starting point, and what becomes of it
    bool arrows;   // from x to f(x)
    bool circles;  // with basins, and the mean over circles
    bool shape;    // the shape: it is framed, painted on, cut in space and probed
    bool starts;   // the starts of views whose orbits all begin at one point
    bool pins;     // settings of the parameters, and the places of other views
    // All its orbits begin at one point, which is the view's own, and may be a critical one.
    bool ownStart;
};
const ViewTraits& traitsOf(ViewKind kind);
const ViewTraits& traitsOf(const Scene& scene);

// What is shown beside a view of this kind.
ViewKind besideOf(ViewKind kind);

}  // namespace versorium
