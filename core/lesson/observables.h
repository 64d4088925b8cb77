// SPDX-License-Identifier: MIT
#pragma once
// What a lesson can ask of the studio's state, by name. All numbers of the map have their own names
// (scene/numbers.h): "c.re", "r", "alpha"; "z.re" is the starting point's. Besides them:
//
//   iterations, escape_radius       N and R of the first view
//   orbit_at, orbit_steps           the marked step of the orbit, and how many are drawn
//   height, center.x, center.y      of the focused view
//   escapes                         1 where the orbit of the starting point leaves the circle R
//                                   within N steps, else 0
//   escape_step                     the step at which it does; N where it does not
//   captured                        1 - escapes
//   period                          of the attracting cycle that the orbit ends on; 0 for none
//   lyapunov                        its exponent; NaN where the orbit escapes
//   end.x, end.y                    where it is after N steps, at most 1000; NaN where it escapes
//   critical_period, critical_escapes   period and escapes of the map's first critical point
//   catalogue                       1 where the first view of parameters may be read as a catalogue
//                                   of Julia sets (dynamics/catalogue_badge.h), else 0
//   share                           of a grid of 64 x 64 points of the first view of starting
//                                   points: the part that does not escape, 0 … 1
//   pins, pin_distance              how many there are; between the first and the present numbers
//   roots, poles                    how many the map has
//
// Of shape modulus maps over the complex numbers:
//
//   shape_share                     the part of that grid that lies in the shape
//   fit                             points in both the set and the shape, of those in either
//   corners                         of a shape that was drawn, or is an outline; else 0
//   phi, mean_phi                   φ at the starting point; its mean over the circle around 0
//                                   through it
//   capture_radius                  within which all orbits stay, whatever the versor
//   members                         of the first view that averages over maps; 0 without one
//   mean_membership                 part of them, of at most 2000, whose set holds the start
//
// Of complex maps, with circles that were dropped:
//
//   circles                         how many there are
//   circles_captured, circles_escaping, circles_decided   of which 256 points all stay, all
//                                   escape, or some do
//   circle.x, circle.y, circle.radius   of the first one

#include <string>
#include <vector>

#include "workspace/workspace.h"

namespace versorium {

// Whether the name stands for something in this workspace.
bool isObservable(const Workspace& workspace, const std::string& name);
// NaN where it cannot be measured: a shape whose grid takes time to make (a mesh), an orbit that
// escapes, a map that has no such thing.
double observe(const Workspace& workspace, const std::string& name);
// For error messages.
std::string observableNames(const Workspace& workspace);

}  // namespace versorium
