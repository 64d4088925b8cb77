// SPDX-License-Identifier: MIT
#pragma once
// What a lesson can ask of the studio's state, by name. All numbers of the map have their own names
// (scene/numbers.h): "c.re", "r", "alpha"; "z.re" is the starting point's. Besides them:
//
//   iterations, escape_radius       N and R of the first view
//   orbit_at, orbit_steps           the marked step of the orbit, and how many are drawn
//   height, center.x, center.y      of the marked view
//   escapes                         1 where the orbit of the starting point leaves the circle R
//                                   within N steps, else 0
//   escape_step                     the step at which it does; N where it does not
//   captured                        1 - escapes
//   period                          of the attracting cycle that the orbit ends on; 0 for none
//   lyapunov                        its exponent; NaN where the orbit escapes
//   critical_period, critical_escapes   the same of the map's first critical point
//   share                           of a grid of 64 x 64 points of the first view of starting
//                                   points: the part that does not escape, 0 … 1
//   pins, circles                   how many there are
//   pin_distance                    between the first pinned setting and the present one
//   roots, poles                    how many the map has

#include <string>
#include <vector>

#include "workspace/workspace.h"

namespace versorium {

// Whether the name stands for something in this workspace.
bool isObservable(const Workspace& workspace, const std::string& name);
// NaN where it cannot be measured: a shape whose grid takes time to make, a diverging orbit.
double observe(const Workspace& workspace, const std::string& name);
// For error messages.
std::string observableNames(const Workspace& workspace);

}  // namespace versorium
