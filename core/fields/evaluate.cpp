// SPDX-License-Identifier: MIT
#include "fields/evaluate.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "fields/ensemble.h"
#include "fields/lanes_of_orbits.h"
#include "fields/observers.h"

namespace versorium {
namespace {

bool wants(std::span<const FieldName> fields, std::initializer_list<FieldName> names) {
    return std::any_of(fields.begin(), fields.end(), [&](FieldName field) {
        return std::find(names.begin(), names.end(), field) != names.end();
    });
}

// ν = n + 1 - log_d(ln|z| / ln R), cut to [n, n + 1].
double smoothStep(const OrbitProgram& program, int n, double squaredNorm) {
    const double ratio = log(squaredNorm) / (2 * log(program.escapeRadius));
    if (!(ratio > 1) || !(program.escapeRadius > 1) || std::isinf(ratio))
        return n + (ratio > 1 ? 0 : 1);
    const double fraction = 1 - log(ratio) / log(program.degree);
    return n + std::clamp(fraction, 0.0, 1.0);
}

constexpr double kLargestMeasured = 1e36;

// The same with d = L_n / L_(n-1), L = ln(1 + |z|²), so that ν is continuous whatever the growth:
// where |z_n| passes R, the first term is n on both sides.
double measuredStep(const OrbitProgram& program, int n, double squaredNorm, double previous) {
    const double bound = program.escapeRadius * program.escapeRadius;
    // What 32 bits cannot hold counts as the same, here and on the GPU.
    const double last = log(1 + std::min(squaredNorm, kLargestMeasured));
    const double before = log(1 + previous);
    if (!std::isfinite(bound) || std::isnan(squaredNorm)) return n;
    if (!(before > 0) || !(last > before)) return n + 1;
    const double passed = log(last / log(1 + bound)) / log(last / before);
    return n + 1 - std::clamp(passed, 0.0, 1.0);
}

double escapeField(FieldName field, const OrbitProgram& program, const EscapeResult& result,
                   std::size_t i) {
    const int n = std::min(result.steps[i], program.iterations);
    const bool escaped = result.escaped[i];
    const double norm = result.squaredNorm[i];
    switch (field) {
        case FieldName::membership:
            return escaped ? 0 : 1;
        case FieldName::escapeStep:
            return n;
        case FieldName::smoothEscape:
            if (!escaped) return n;
            return result.previousNorm.empty() || program.onlyLastTested
                       ? smoothStep(program, n, norm)
                       : measuredStep(program, n, norm, result.previousNorm[i]);
        case FieldName::squaredNorm:
            return norm;
        case FieldName::logModulus:
            return 0.5 * log(norm);
        default:
            return isSolid(program, norm) ? 1 : 0;
    }
}

void imageFields(const OrbitProgram& program, OrbitLanes& lanes, FieldName field,
                 std::vector<double>& out) {
    const auto count = static_cast<std::size_t>(lanes.count());
    const auto dimension = static_cast<std::size_t>(program.map->dimension);
    for (std::size_t i = 0; i < count; ++i) {
        double norm = 0;
        for (std::size_t k = 0; k < dimension; ++k) {
            const double part = lanes.state(static_cast<int>(k))[i];
            norm = norm + part * part;
        }
        const double modulus = std::sqrt(norm);
        if (field == FieldName::imageModulus) {
            out[i] = modulus;
        } else if (field == FieldName::argument) {
            out[i] = atan2(dimension > 1 ? lanes.state(1)[i] : 0.0, lanes.state(0)[i]);
        } else {
            for (std::size_t k = 0; k < dimension; ++k)
                out[k * count + i] = lanes.state(static_cast<int>(k))[i] / modulus;
        }
    }
}

// Of a map alone the mean is the membership itself.
void ensembleFields(const OrbitProgram& program, int count, const double* const* coordinates,
                    const EvaluateOptions& options, std::vector<double>& mean,
                    std::vector<double>& error) {
    mean.resize(static_cast<std::size_t>(count));
    error.resize(mean.size());
    if (!program.ensemble || !program.ensemble->varies()) {
        const bool solid = program.ensemble && program.ensemble->solid;
        const FieldName field[] = {solid ? FieldName::solid : FieldName::membership};
        mean = evaluateFields(program, count, coordinates, field, options)[0];
        return;
    }
    std::vector<std::uint32_t> counted;
    const std::uint32_t* counts = options.counts;
    const std::uint64_t members = counts ? options.members : program.ensemble->count;
    if (!counts) {
        counted.assign(mean.size(), 0);
        countMembers(program, 0, members, count, coordinates, counted.data(), options);
        counts = counted.data();
    }
    for (std::size_t i = 0; i < mean.size(); ++i) {
        mean[i] = meanOf(counts[i], members);
        error[i] = standardErrorOf(counts[i], members);
    }
}

}  // namespace

bool isSolid(const OrbitProgram& program, double squaredNorm) {
    return 0.5 * log(squaredNorm) < program.iso;
}

int channelCount(FieldName field, const OrbitProgram& program) {
    return field == FieldName::versor ? program.map->dimension : 1;
}

std::vector<std::vector<double>> evaluateFields(const OrbitProgram& program, int count,
                                                const double* const* coordinates,
                                                std::span<const FieldName> fields,
                                                const EvaluateOptions& options) {
    using enum FieldName;
    std::vector<std::vector<double>> out;
    for (FieldName field : fields)
        out.emplace_back(static_cast<std::size_t>(count * channelCount(field, program)));

    const OrbitLanes start(program, count, coordinates, options);
    // The last iterate of orbits inside matters to these only.
    const Needed needed = wants(fields, {squaredNorm, logModulus, solid, period}) ? Needed::last
                          : wants(fields, {smoothEscape})                         ? Needed::escaped
                                                                                  : Needed::steps;
    EscapeResult escape;
    OrbitLanes last = start;
    if (needed != Needed::steps || wants(fields, {membership, escapeStep}))
        escape = EscapeRun(program, options).run(last, needed);
    OrbitLanes image = start;
    if (wants(fields, {imageModulus, versor, argument})) image.advance(1);
    Observed observed;
    if (wants(fields, {attractionStep, trap, lyapunov}))
        observed = observe(program, start, wants(fields, {lyapunov}));

    std::vector<double> mean, error;
    if (wants(fields, {meanMembership, standardError}))
        ensembleFields(program, count, coordinates, options, mean, error);

    for (std::size_t f = 0; f < fields.size(); ++f) {
        std::vector<double>& values = out[f];
        switch (fields[f]) {
            case imageModulus:
            case versor:
            case argument:
                imageFields(program, image, fields[f], values);
                break;
            case attractionStep:
                values = observed.attractionStep;
                break;
            case FieldName::trap:
                values = observed.trap;
                break;
            case lyapunov:
                values = observed.lyapunov;
                break;
            case distance:
                values = distanceEstimates(program, start);
                break;
            case period:
                values = periodsOf(program, last, escape);
                break;
            case meanMembership:
                values = mean;
                break;
            case standardError:
                values = error;
                break;
            default:
                for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i)
                    values[i] = escapeField(fields[f], program, escape, i);
        }
        for (double& value : values)
            if (std::isnan(value)) value = std::numeric_limits<double>::quiet_NaN();
    }
    return out;
}

std::vector<std::vector<double>> orbitOf(const OrbitProgram& program, const double* coordinates,
                                         int steps) {
    const double* pointers[3] = {coordinates, coordinates + 1, coordinates + 2};
    OrbitLanes lanes(program, 1, pointers, {});
    std::vector<std::vector<double>> orbit;
    for (int n = 0; n <= steps; ++n) {
        std::vector<double> row;
        for (int k = 0; k < program.map->dimension; ++k) row.push_back(lanes.state(k)[0]);
        orbit.push_back(row);
        if (!(lanes.squaredNorm(0) <= program.escapeRadius * program.escapeRadius)) break;
        if (n < steps) lanes.advance(1);
    }
    return orbit;
}

}  // namespace versorium
