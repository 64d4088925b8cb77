// SPDX-License-Identifier: MIT
#pragma once
// The mean of a distance field φ over the circle (of the plane) or sphere (of space) of radius r
// around the origin of the dynamical system, against r (S section 3.3.1, Fig 8 bottom), with what
// it says about the shape modulus r̂ = e^{α(φ - β)}: where r̂ lies below r orbits tend to fall, where
// it lies above they tend to rise.

#include <array>
#include <vector>

#include "jobs/job.h"
#include "shape/field.h"

namespace versorium {

struct RadialOptions {
    int dimensions = 2;             // 2: circles in the plane z = 0; 3: spheres
    std::array<double, 3> shift{};  // of the shape against the origin: φ is taken at x - shift
    double alpha = 8, beta = 0;     // where the field does not modulate them
    bool asPrinted = false;         // S eq 2 with the sign in print: φ + β
    double escapeRadius = 20;
    double to = 2;        // the largest radius
    int radii = 257;      // from 0 to `to`, evenly
    bool outward = true;  // whether `escape` is looked for
    // With how many radii up to the escape radius, and points on each circle.
    int outwardRadii = 4097, outwardPoints = 1024;
    int points = 0;  // on each circle or sphere; 0: 4096 and 16384
};

struct RadialProfile {
    // One for each radius. `low` and `high` bound φ on the whole circle or sphere, between the
    // points as well (see `slope`).
    std::vector<double> radius, mean, low, high;
    std::vector<double> modulus;  // r̂ of the mean, with the options' α and β
    // How fast φ can change: 1 for analytic shapes; of a grid, as much as between its nodes.
    double slope = 1;
    // Orbits that start within `capture` stay within it: r̂ <= capture on that ball. The largest
    // such radius among those above, at most the escape radius; 0 where none is found.
    double capture = 0;
    // Of the plane: orbits that start beyond `escape` leave sooner or later, since r̂ > r from there
    // to the escape radius. It is the escape radius itself where nothing less is sure, and always
    // in space, where φ does not see the component that is dropped.
    double escape = 20;
};

// ErrorKind::usage for options out of range; cancelled.
Expected<RadialProfile> radialProfile(const DistanceField& field, const RadialOptions& options,
                                      Job& job);

inline constexpr int kMostRadii = 100000;
inline constexpr int kMostCirclePoints = 1 << 20;

}  // namespace versorium
