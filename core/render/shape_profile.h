// SPDX-License-Identifier: MIT
#pragma once
// The radial profile (shape/radial_profile.h) of a scene's shape, with the scene's α, β, shift and
// escape radius.

#include "render/bind.h"
#include "shape/radial_profile.h"

namespace versorium {

// `to` <= 0: one and a half times the farthest corner of the shape's box. ErrorKind::usage for a
// map without a shape. Over the quaternions the sphere lies in the three components that the shape
// is looked up at.
Expected<RadialProfile> shapeProfile(Binder& binder, const Scene& scene, double to, int radii,
                                     Job& job);

// What the profile follows from, without the radii: the scene's α, β, shift and escape radius.
RadialOptions radialOptions(const Scene& scene, double escapeRadius);
// How far the shape reaches from the origin of the dynamical system.
double shapeReach(const DistanceField& field, const RadialOptions& options);

// "radius,mean_phi,low,high,modulus", a row for each radius.
std::string profileCsv(const RadialProfile& profile);

}  // namespace versorium
