// SPDX-License-Identifier: MIT
#pragma once
// All the numbers that fix an orbit of a scene have names: components of the state ("z.re"),
// of the parameters ("c.im", "power") and of lists ("roots[2].re", "roots[2].power"). A slice, an
// axis label, --set and an animation reach them by these.

#include <optional>
#include <string>

#include "scene/scene.h"

namespace versorium {

enum class NumberKind { state, parameter, list };

struct NumberRef {
    NumberKind kind;
    int index = 0;  // component of the state or of all parameters
    std::string list;
    int listIndex = 0, item = 0, component = 0;  // component 4 is the power
};

std::optional<NumberRef> numberNamed(const Scene& scene, const std::string& name);
// Its value in the scene, whatever the slice.
double numberValue(const Scene& scene, const NumberRef& number);
void setNumber(Scene& scene, const NumberRef& number, double value);
// Whether views that share their numbers have each their own value of it.
bool isOfView(const Scene& scene, const NumberRef& number);
// Whether a number varies along an axis of a slice.
bool isOnAxis(const SliceSpec& slice, const std::string& name);
// All names for error messages, lists abbreviated.
std::string numberNames(const Scene& scene);

}  // namespace versorium
