// SPDX-License-Identifier: MIT
#pragma once
// The dynamical system of a scene: what its map does with the scene's own parameters, whatever the
// slice. Numbers on an axis of the slice take the values that the scene gives them: those are where
// the ring stands in a picture of parameters.

#include "dynamics/catalogue_badge.h"
#include "dynamics/system.h"
#include "render/bind.h"

namespace versorium {

// The scene's program with every number fixed: its slice has axes of nothing but 0.
Expected<OrbitProgram> fixedProgram(Binder& binder, const Scene& scene, Job& job);
Expected<System> systemOf(Binder& binder, const Scene& scene, Job& job);

// The same program with one axis, along the numbers of `axis`: what a bifurcation diagram runs
// over. ErrorKind::usage where the map has no such number or the axis moves the start.
Expected<OrbitProgram> programAlong(Binder& binder, const Scene& scene, const SliceAxis& axis,
                                    Job& job);

// Whether the scene's picture is a catalogue of Julia sets (A8).
Expected<CatalogueBadge> catalogueBadgeOf(Binder& binder, const Scene& scene, Job& job);

// Whether the first two axes (the first one, on the line) are the components of the state, each by
// itself: then the picture's coordinates are those of points of the system.
bool isDynamicalPlane(const Scene& scene);
// The borders of the scene's dynamical plane: of its slice where that is one of starting points,
// else the map's home view.
Window dynamicalWindow(const Scene& scene);

}  // namespace versorium
