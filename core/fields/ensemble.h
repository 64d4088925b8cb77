// SPDX-License-Identifier: MIT
#pragma once
// An ensemble: many maps that differ in numbers drawn at random. Its mean membership is, at every
// point, the part of the maps whose set holds the point (S Fig 8 top, there 1000 random versors).
// Each member is drawn from the seed and its own number, so the members may be counted in any order
// and any parts: the counts are whole numbers and come out the same to the bit.

#include <cstdint>
#include <vector>

#include "fields/evaluate.h"
#include "geometry/random_roots.h"

namespace versorium {

struct Ensemble {
    std::uint64_t count = 1000, seed = 1;
    bool solid = false;  // of the solid set, else of membership
    // Roots of this list are drawn anew for each member; -1: none are.
    int list = -1;
    RandomRoots roots;
    // Numbers of the slice (state, parameters, overrides), drawn uniformly from a range, or two of
    // them from a disc.
    struct Range {
        std::size_t number;
        double from, to;
    };
    struct Disc {
        std::size_t re, im;
        double centreRe, centreIm, radius;
    };
    std::vector<Range> ranges;
    std::vector<Disc> discs;

    // Every orbit that comes this near to the origin of a shape-modulus map stays there, whatever
    // the roots (shape/radial_profile.h: capture); 0 where nothing is known.
    double capture = 0;

    bool varies() const { return list >= 0 || !ranges.empty() || !discs.empty(); }
    // Makes `program`, which is any member, the one of this number.
    void choose(std::uint64_t member, OrbitProgram& program) const;
};

// counts[i] grows by the number of members first … first + members - 1 whose set holds point i.
// False where options.stop ended it: then the counts are of no use.
bool countMembers(const OrbitProgram& program, std::uint64_t first, std::uint64_t members,
                  int count, const double* const* coordinates, std::uint32_t* counts,
                  const EvaluateOptions& options);

// The mean of `members` yes-no values of which `count` are yes, and its standard error
// sqrt(p (1 - p) / (members - 1)): NaN for fewer than two members, and 0 where all agree (then p
// lies within 3/members of what is seen, at 95 %).
double meanOf(std::uint32_t count, std::uint64_t members);
double standardErrorOf(std::uint32_t count, std::uint64_t members);

}  // namespace versorium
