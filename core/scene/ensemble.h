// SPDX-License-Identifier: MIT
#pragma once
// What varies in a scene's ensemble (fields/ensemble.h says what is counted over it).

#include <optional>
#include <string>
#include <vector>

#include "base/status.h"
#include "base/words.h"
#include "geometry/random_roots.h"

namespace versorium {

struct Scene;

// A list of roots that is drawn anew for each member.
struct EnsembleRoots {
    std::string list = "roots";
    // The region is the box of the scene's shape, in the components that the shape is looked up at;
    // else that of `draw`.
    bool shapeBox = true;
    RandomRoots draw;
    friend bool operator==(const EnsembleRoots&, const EnsembleRoots&) = default;
};
// A number by its name ("alpha", "c.re", "roots[2].power"), uniform in [from, to].
struct EnsembleRange {
    std::string name;
    double from = 0, to = 1;
    friend bool operator==(const EnsembleRange&, const EnsembleRange&) = default;
};
// A complex number by its name ("c": c.re and c.im), uniform in a disc.
struct EnsembleDisc {
    std::string name;
    double centreRe = 0, centreIm = 0, radius = 1;
    friend bool operator==(const EnsembleDisc&, const EnsembleDisc&) = default;
};

enum class AveragedSet { membership, solid };
template <>
struct EnumWords<AveragedSet> {
    static constexpr std::array<std::string_view, 2> table{"membership", "solid"};
};

struct EnsembleSpec {
    int count = 1000;  // members
    int seed = 1;
    AveragedSet set = AveragedSet::membership;  // whose mean is taken
    std::optional<EnsembleRoots> roots;
    std::vector<EnsembleRange> ranges;
    std::vector<EnsembleDisc> discs;
    bool varies() const { return roots || !ranges.empty() || !discs.empty(); }
    friend bool operator==(const EnsembleSpec&, const EnsembleSpec&) = default;
};

inline constexpr int kMostMembers = 100000000;
inline constexpr std::size_t kMostEnsembleNumbers = 16;

// That the names are those of numbers of the scene which nothing else sets.
Status checkEnsemble(const Scene& scene);
// What came to lie on an axis of the picture is drawn no longer.
void keepEnsembleFitting(Scene& scene);

}  // namespace versorium
