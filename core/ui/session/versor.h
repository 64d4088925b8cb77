// SPDX-License-Identifier: MIT
#pragma once
// What can be done with the roots and poles of a map, in all views of a workspace at once: a root
// is moved, raised to another power, added, taken away; a list is drawn at random; product and sum
// take each other's place.

#include <array>
#include <optional>
#include <string>

#include "scene/ensemble.h"
#include "workspace/workspace.h"

namespace versorium {

struct StudioContext;

// A root by its list ("roots", "poles", …) and place; item -1: none.
struct RootRef {
    std::string list;
    int item = -1;
    friend bool operator==(const RootRef&, const RootRef&) = default;
};

bool hasRoots(const Workspace& workspace);
bool isRoot(const Workspace& workspace, const RootRef& ref);
const RootList::Root& rootAt(const Workspace& workspace, const RootRef& ref);
// The power that counts: with the list's scale, and negative for poles.
double exponentOf(const Workspace& workspace, const RootRef& ref);
// Where a root lies among starting points: a shape modulus looks at x = z - shift.
std::array<double, 4> placeOfRoot(const Scene& scene, const RootList::Root& root);
std::array<double, 4> rootOfPlace(const Scene& scene, const std::array<double, 4>& place);

void setRoot(Workspace& workspace, const RootRef& ref, const RootList::Root& root);
// At the end of its list. ErrorKind::usage where the list is full.
Expected<RootRef> addRoot(Workspace& workspace, const std::string& list,
                          const RootList::Root& root);
// ErrorKind::usage where a picture's axis, an ensemble or the motion needs it, or one after it.
Status removeRoot(Workspace& workspace, const RootRef& ref);
// All of a list at once, under the same condition.
Status setRootList(Workspace& workspace, const std::string& list, const RootList& roots);
// A zero becomes a pole of the same power, and the other way round: it goes to the other list, or
// its power changes its sign where there is but one.
Expected<RootRef> turnRoot(Workspace& workspace, const RootRef& ref);

// "complex-root-sum" for "complex-rational" and so on, and back; empty where there is none.
std::string sumOrProductOf(const std::string& map);
bool isRootSum(const std::string& map);
// d from the sum of powers in place of the product, or back: everything else stays.
void takeRootSum(Workspace& workspace, bool sum);

// How the roots of the panel and of the contact sheet are drawn. The region is the box of the
// shape, where there is one.
inline constexpr int kMostSeed = 2147483647;
struct RootDraw {
    RandomRoots options;
    int seed = 1;
};
// What hand and panel are at, beside the workspace.
struct VersorState {
    RootRef chosen;     // the root whose numbers are shown
    double turned = 0;  // of the wheel, less than a step
    RootDraw draw;
};

// The list that is drawn: the map's first one.
std::string drawnList(const Workspace& workspace);
// The options with their region. ErrorKind::usage where they are out of range; nothing is known of
// a shape whose grid is still being made.
Expected<RandomRoots> drawOptions(StudioContext& context);
// The seed's roots become those of the map.
void drawRoots(StudioContext& context, int seed);

}  // namespace versorium
