// SPDX-License-Identifier: MIT
#pragma once
// Changes of roots and poles by hand (session/versor.h): each is a step of the history, the root
// that it was done to is the chosen one, and what could not be done is said.

#include <array>
#include <string>

#include "ui/session/versor.h"

namespace versorium {

struct StudioContext;

// Of power 1, at a place among starting points. An empty list is the map's first one.
void addRootAtPlace(StudioContext& context, const std::string& list,
                    const std::array<double, 4>& place);
// At the orbit's point.
void addRootAtPoint(StudioContext& context, const std::string& list = {});
// Clamped to what a root may have.
void setRootPower(StudioContext& context, const RootRef& ref, double power);
// A zero becomes a pole, and the other way round.
void turnChosenRoot(StudioContext& context);
void removeChosenRoot(StudioContext& context);

}  // namespace versorium
