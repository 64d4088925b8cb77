// SPDX-License-Identifier: MIT
#include "fields/ensemble.h"

#include <cmath>
#include <limits>

#include "fields/lanes_of_orbits.h"

namespace versorium {
namespace {

// Some of the points, their coordinates along the slice's axes gathered.
struct Points {
    std::vector<std::size_t> index;
    std::vector<std::vector<double>> coordinates;

    explicit Points(std::size_t axes) : coordinates(axes) {}
    void add(std::size_t i, const double* const* from) {
        index.push_back(i);
        for (std::size_t axis = 0; axis < coordinates.size(); ++axis)
            coordinates[axis].push_back(from[axis][i]);
    }
};

// |f| does not depend on the direction p: where it is beyond the escape radius for one member's
// roots, the orbit escapes at step 1 for every member, and where it is within the radius of capture
// every member keeps it. The modulus is the same but for rounding, for which there is a margin.
constexpr double kRoundingMargin = 1e-9;

// Points whose fate the first modulus does not decide. Those that it keeps are counted at once.
Points undecided(const OrbitProgram& program, const Ensemble& ensemble, std::uint64_t members,
                 int count, const double* const* coordinates, std::uint32_t* counts,
                 const EvaluateOptions& options) {
    Points points(program.slice.axes.size());
    const bool onlyRoots = ensemble.ranges.empty() && ensemble.discs.empty();
    const bool known = options.shortcuts && onlyRoots && program.map->info.field &&
                       program.iterations >= 1 && !program.onlyLastTested;
    std::vector<double> modulus, starts;
    if (known) {
        const FieldName first[] = {FieldName::imageModulus};
        modulus = evaluateFields(program, count, coordinates, first, options)[0];
        OrbitProgram begin = program;
        begin.iterations = 0;
        const FieldName within[] = {FieldName::membership};
        starts = evaluateFields(begin, count, coordinates, within, options)[0];
    }
    const double capture = ensemble.solid ? 0 : ensemble.capture * (1 - kRoundingMargin);
    const double escape = program.escapeRadius * (1 + kRoundingMargin);
    for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
        if (known && modulus[i] > escape) continue;
        if (known && starts[i] != 0 && modulus[i] <= capture)
            counts[i] += static_cast<std::uint32_t>(members);
        else
            points.add(i, coordinates);
    }
    return points;
}

}  // namespace

void Ensemble::choose(std::uint64_t member, OrbitProgram& program) const {
    Random random = Random::stream(seed, member);
    if (list >= 0) program.lists[static_cast<std::size_t>(list)] = randomRoots(roots, random).roots;
    for (const Range& range : ranges)
        program.slice.origin[range.number] = random.uniform(range.from, range.to);
    for (const Disc& disc : discs) {
        double re = 0, im = 0;
        do {
            re = random.uniform(-1, 1);
            im = random.uniform(-1, 1);
        } while (re * re + im * im > 1);
        program.slice.origin[disc.re] = disc.centreRe + disc.radius * re;
        program.slice.origin[disc.im] = disc.centreIm + disc.radius * im;
    }
}

bool countMembers(const OrbitProgram& program, std::uint64_t first, std::uint64_t members,
                  int count, const double* const* coordinates, std::uint32_t* counts,
                  const EvaluateOptions& options) {
    if (members == 0) return true;
    const Ensemble& ensemble = *program.ensemble;
    OrbitProgram member = program;
    ensemble.choose(first, member);
    const Points points = undecided(member, ensemble, members, count, coordinates, counts, options);
    if (points.index.empty()) return true;
    std::vector<const double*> pointers;
    for (const std::vector<double>& along : points.coordinates) pointers.push_back(along.data());
    const bool solid = ensemble.solid;
    const int size = static_cast<int>(points.index.size());
    // Where nothing but the roots differs, all members start from the same states.
    const bool same = ensemble.ranges.empty() && ensemble.discs.empty() && !program.critical;
    OrbitLanes lanes(member, size, pointers.data(), options);
    const OrbitLanes start = lanes;
    EscapeRun run(member, options, solid ? 0 : ensemble.capture);
    for (std::uint64_t k = 0; k < members; ++k) {
        if (options.stop && options.stop()) return false;
        if (k > 0) {
            ensemble.choose(first + k, member);
            if (same)
                lanes.startAt(start);
            else
                lanes = OrbitLanes(member, size, pointers.data(), options);
        }
        const EscapeResult& result = run.run(lanes, solid ? Needed::last : Needed::steps);
        for (std::size_t i = 0; i < points.index.size(); ++i)
            counts[points.index[i]] +=
                solid ? isSolid(member, result.squaredNorm[i]) : result.escaped[i] == 0;
    }
    return true;
}

double meanOf(std::uint32_t count, std::uint64_t members) {
    if (members == 0) return std::numeric_limits<double>::quiet_NaN();
    return static_cast<double>(count) / static_cast<double>(members);
}

double standardErrorOf(std::uint32_t count, std::uint64_t members) {
    if (members < 2) return std::numeric_limits<double>::quiet_NaN();
    const double mean = meanOf(count, members);
    return std::sqrt(mean * (1 - mean) / static_cast<double>(members - 1));
}

}  // namespace versorium
