// SPDX-License-Identifier: MIT
#include "dynamics/catalogue_badge.h"

#include <algorithm>
#include <cmath>

#include "base/json.h"
#include "base/random.h"
#include "dynamics/critical_set.h"
#include "dynamics/planar_system.h"
#include "dynamics/system.h"
#include "maps/critical.h"

namespace versorium {
namespace {

// Of det J, in units of the squared size of J. Of a complex-analytic map det J = |f'|².
constexpr double kZero = 1e-9, kZeroAnalytic = 1e-18;
constexpr int kAcross = 5;

// The system at one point of the picture, with its start.
struct Sample {
    System system;
    std::vector<double> start;
    bool exists = true;  // the start: a critical point may not
};

Sample sampleAt(const OrbitProgram& program, const double* coordinates) {
    Sample sample{System(program, coordinates), {}, true};
    const auto dimension = static_cast<std::size_t>(program.map->dimension);
    for (std::size_t k = 0; k < dimension; ++k)
        sample.start.push_back(program.slice.at(k, coordinates));
    if (program.critical)
        sample.exists =
            criticalPoint(*program.map, *program.critical, sample.system.parameters().data(),
                          sample.system.environment(), sample.start.data());
    return sample;
}

struct Local {
    double determinant = 0;
    double size = 0;  // of J: the sum of the squares of its entries
    // From a multiplication by a complex number, and by one after conjugation; squared.
    double difference = 0, conjugate = 0;
};
Local localAt(const System& system, const double* point) {
    double at[2] = {point[0], system.dimension() == 2 ? point[1] : 0.0}, j[4] = {};
    system.stepWithJacobian(at, j);
    if (system.dimension() == 1) return {j[0], 1 + j[0] * j[0], 0, 0};
    const double a = j[0] - j[3], b = j[1] + j[2], c = j[0] + j[3], d = j[1] - j[2];
    return {j[0] * j[3] - j[1] * j[2], j[0] * j[0] + j[1] * j[1] + j[2] * j[2] + j[3] * j[3],
            a * a + b * b, c * c + d * d};
}

bool isCritical(const Sample& sample, bool analytic) {
    if (!sample.exists) return false;
    const Local local = localAt(sample.system, sample.start.data());
    const double zero = analytic && sample.system.dimension() == 2 ? kZeroAnalytic : kZero;
    return std::abs(local.determinant) <= zero * (1 + local.size);
}

bool isPlanar(const System& system) { return system.map().info.planarCoefficients; }

bool isAnalytic(const System& system, bool conjugate) {
    if (system.dimension() == 1) return !conjugate;
    if (isPlanar(system))
        return conjugate ? complexPolynomialOf(conjugateOf(system.parameters())).has_value()
                         : complexPolynomialOf(system.parameters()).has_value();
    // Elsewhere the equations are asked at points, away from poles and axes.
    Random random(17);
    for (int i = 0; i < 12; ++i) {
        const double at[2] = {random.uniform(-2, 2), random.uniform(-2, 2)};
        const Local local = localAt(system, at);
        const double difference = conjugate ? local.conjugate : local.difference;
        if (std::isfinite(local.size) && !(difference <= 1e-14 * local.size)) return false;
    }
    return true;
}

// Distinct critical points of an analytic map: all, and those that the map does not fix.
struct Count {
    int all = 0, free = 0;
};
Count countCritical(const System& system) {
    const std::vector<PlanePoint> points = criticalPointsOf(system);
    Count count;
    count.all = static_cast<int>(points.size());
    for (const PlanePoint& point : points) {
        PlanePoint image = point;
        system.step(image.data());
        count.free += !(std::abs(image[0] - point[0]) + std::abs(image[1] - point[1]) < 1e-7);
    }
    return count;
}

// det J of a planar polynomial: everywhere 0, nowhere 0 because it is constant, or neither.
enum class Determinant { zero, constant, varies };
Determinant determinantKind(const System& system) {
    const PlanarDeterminant determinant = determinantOf(system.parameters());
    double rest = 0;
    for (std::size_t i = 0; i < determinant.size(); ++i)
        for (std::size_t k = 0; k < determinant.size(); ++k)
            if (i + k > 0) rest = std::max(rest, std::abs(determinant[i][k]));
    if (rest > 1e-14) return Determinant::varies;
    return determinant[0][0] == 0 ? Determinant::zero : Determinant::constant;
}

std::string pointText(const std::vector<double>& point) {
    std::string text;
    for (double part : point) text += (text.empty() ? "" : ", ") + formatNumber(part, 6);
    return point.size() == 1 ? text : "(" + text + ")";
}

void say(CatalogueBadge& badge, CatalogueAnswer answer, std::string label, std::string sentence) {
    badge.answer = answer;
    badge.label = std::move(label);
    badge.sentence = std::move(sentence);
}

void answerAnalytic(CatalogueBadge& badge, const MapKernels& map, const Count& count,
                    bool everywhere, bool somewhere, bool fixed) {
    badge.criticalPoints = count.all;
    const bool line = map.dimension == 1;
    const std::string kind = badge.conjugate ? "The map is the complex conjugate of an analytic one"
                                             : "The map is complex-analytic";
    if (count.all == 0 && !somewhere)
        return say(
            badge, CatalogueAnswer::noCriticalPoint, "no critical point",
            "The derivative of this map vanishes nowhere, so that no orbit can tell what all "
            "others do: the picture is no catalogue of Julia sets.");
    if (!everywhere)
        return say(badge, CatalogueAnswer::notCritical, "not a critical point",
                   "The start " + pointText(badge.start) +
                       (somewhere ? " is a critical point for some of these parameters only"
                                  : " is not a critical point") +
                       ": whether its orbit escapes says nothing of the Julia sets.");
    if (line)
        return say(badge, CatalogueAnswer::onlyCriticalOrbit, "the only critical orbit",
                   "The orbit starts at the critical point of a map of the line: where a cycle "
                   "attracts, it attracts this orbit (Singer, for these families).");
    if (fixed && count.free > 0)
        return say(badge, CatalogueAnswer::oneOfSeveral, "a critical point that is fixed",
                   "The orbit starts at a critical point that the map fixes for all of these "
                   "parameters: it stays wherever the others go.");
    if (count.free <= 1 && count.all <= 1)
        return say(badge, CatalogueAnswer::onlyCriticalOrbit, "the only critical orbit",
                   kind +
                       " and the orbit starts at its only critical point: the picture is a "
                       "catalogue, with connected Julia sets exactly where the orbit "
                       "stays bounded (Fatou and Julia).");
    if (count.free <= 1)
        return say(badge, CatalogueAnswer::onlyCriticalOrbit, "the only free critical orbit",
                   kind +
                       ", and its other critical points are fixed: the orbit of the only free one "
                       "decides what its Julia sets are like.");
    say(badge, CatalogueAnswer::oneOfSeveral,
        "one of " + std::to_string(count.free) + " critical orbits",
        kind + " and has " + std::to_string(count.free) +
            " free critical points, of which the picture follows one: where its orbit escapes the "
            "Julia set is not connected, where it stays the other orbits decide as well.");
}

// What is found over the picture, at kAcross points along each axis, the middle among them.
struct Survey {
    bool everywhere = true, somewhere = false;  // the start is critical
    bool exists = true, fixed = true;           // there is a start; the map leaves it where it is
    bool constant = false, invertible = false;  // det J of a planar polynomial
    Count count;                                // the most critical points
};

void lookAt(const Sample& sample, const Sample& middle, Survey& survey, CatalogueBadge& badge) {
    const System& system = sample.system;
    badge.analytic = badge.analytic && isAnalytic(system, false);
    badge.conjugate = badge.conjugate && isAnalytic(system, true);
    const bool complex = badge.analytic || badge.conjugate;
    const bool critical = isCritical(sample, complex);
    survey.everywhere = survey.everywhere && critical;
    survey.somewhere = survey.somewhere || critical;
    survey.exists = survey.exists && sample.exists;
    const std::size_t dimension = sample.start.size();
    double image[2] = {sample.start[0], dimension > 1 ? sample.start[1] : 0.0};
    system.step(image);
    for (std::size_t k = 0; k < dimension; ++k) {
        survey.fixed = survey.fixed && std::abs(image[k] - sample.start[k]) < 1e-7;
        badge.startMoves = badge.startMoves || std::abs(sample.start[k] - middle.start[k]) > 1e-9;
    }
    if (survey.constant) {
        const Determinant kind = determinantKind(system);
        survey.constant = kind != Determinant::varies;
        survey.invertible = survey.invertible || kind == Determinant::constant;
    }
    if (!complex) return;
    const Count own = countCritical(system);
    survey.count.all = std::max(survey.count.all, own.all);
    survey.count.free = std::max(survey.count.free, own.free);
}

Survey surveyOf(const OrbitProgram& program, const double* centre, double halfWidth,
                double halfHeight, const Sample& middle, CatalogueBadge& badge) {
    Survey survey;
    survey.constant = isPlanar(middle.system);
    const std::size_t axes = program.slice.axes.size();
    for (int row = 0; row < (axes > 1 ? kAcross : 1); ++row)
        for (int column = 0; column < kAcross; ++column) {
            const double at[3] = {
                centre[0] + halfWidth * (2.0 * column / (kAcross - 1) - 1),
                axes > 1 ? centre[1] + halfHeight * (2.0 * row / (kAcross - 1) - 1) : 0.0,
                axes > 2 ? centre[2] : 0.0};
            lookAt(sampleAt(program, at), middle, survey, badge);
        }
    return survey;
}

// Whether the picture varies parameters alone, so that the question can be asked; else it is
// answered.
bool isAsked(const OrbitProgram& program, CatalogueBadge& badge) {
    const auto dimension = static_cast<std::size_t>(program.map->dimension);
    if (dimension > 2) {
        say(badge, CatalogueAnswer::notAsked, "not a map of line or plane",
            "Critical orbits decide about Julia sets of complex maps; this map has points of " +
                std::to_string(dimension) + " numbers.");
        return false;
    }
    bool parameters = false;
    for (std::size_t k = 0; k < program.slice.origin.size(); ++k) {
        if (!program.slice.varies(k)) continue;
        if (k < dimension) {
            say(badge, CatalogueAnswer::notAsked, "a picture of starting points",
                "The picture varies the starting point: the question is asked of pictures that "
                "vary parameters.");
            return false;
        }
        parameters = true;
    }
    if (!parameters)
        say(badge, CatalogueAnswer::notAsked, "nothing varies", "The picture varies no parameter.");
    return parameters;
}

// Of a map that is not complex-analytic.
void answerReal(CatalogueBadge& badge, const Survey& survey) {
    badge.criticalPoints = -1;
    if (survey.everywhere)
        say(badge, CatalogueAnswer::oneOfSeveral, "a point where det J = 0",
            "The start lies where det J = 0, but the map is not complex-analytic: such points are "
            "in general a whole curve, and one orbit decides nothing about Julia sets. The picture "
            "is a guide for the eye.");
    else
        say(badge, CatalogueAnswer::notCritical, "not a critical point",
            "At the start " + pointText(badge.start) +
                (survey.somewhere ? " det J is 0 for some of these parameters only"
                                  : " det J is not 0") +
                ", and the map is not complex-analytic: the picture shows where one orbit stays "
                "bounded and is no catalogue of Julia sets.");
}

}  // namespace

const char* wordOf(CatalogueAnswer answer) {
    constexpr const char* kWords[] = {"only_critical_orbit", "one_of_several", "not_critical",
                                      "no_critical_point", "not_asked"};
    return kWords[static_cast<int>(answer)];
}

CatalogueBadge catalogueBadge(const OrbitProgram& program, const double* centre, double halfWidth,
                              double halfHeight) {
    CatalogueBadge badge;
    if (!isAsked(program, badge)) return badge;
    const Sample middle = sampleAt(program, centre);
    badge.start = middle.start;
    badge.determinant = localAt(middle.system, middle.start.data()).determinant;
    badge.analytic = badge.conjugate = true;
    const Survey survey = surveyOf(program, centre, halfWidth, halfHeight, middle, badge);
    if (survey.constant && survey.invertible) {
        say(badge, CatalogueAnswer::noCriticalPoint, "no critical point",
            "det J is the same number at every point, as for Hénon's map, so that the map has no "
            "critical point wherever it is not 0: the picture shows where one orbit stays bounded "
            "and is no catalogue of Julia sets.");
        return badge;
    }
    if (!survey.exists) {
        say(badge, CatalogueAnswer::notCritical, "no such critical point",
            "The map has no critical point of this number, at least not everywhere in the "
            "picture.");
        return badge;
    }
    // A constant is both; it counts as analytic.
    badge.conjugate = badge.conjugate && !badge.analytic;
    if (badge.analytic || badge.conjugate)
        answerAnalytic(badge, *program.map, survey.count, survey.everywhere, survey.somewhere,
                       survey.fixed);
    else
        answerReal(badge, survey);
    return badge;
}

}  // namespace versorium
