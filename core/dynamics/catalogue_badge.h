// SPDX-License-Identifier: MIT
#pragma once
// Whether a bifurcation set may be read as a catalogue of Julia sets (A8). For a polynomial over
// the complex numbers the filled Julia set is connected if and only if no critical orbit escapes
// (Fatou and Julia), so that a picture of the only critical orbit says of every parameter what its
// set is like. With k critical orbits it shows one of k conditions; with any other start nothing
// follows.

#include <string>

#include "fields/evaluate.h"

namespace versorium {

enum class CatalogueAnswer {
    onlyCriticalOrbit,  // of a complex-analytic map, or of a map of the line
    oneOfSeveral,       // of k critical orbits, or of a whole curve of them
    notCritical,        // the start is not a critical point, at least not everywhere in the picture
    noCriticalPoint,    // the map has none: det J vanishes nowhere (Hénon)
    notAsked,           // the picture varies the start, or the map is not one of line or plane
};

// "only_critical_orbit", "one_of_several", "not_critical", "no_critical_point", "not_asked".
const char* wordOf(CatalogueAnswer answer);

struct CatalogueBadge {
    CatalogueAnswer answer = CatalogueAnswer::notAsked;
    bool analytic = false;      // the Cauchy-Riemann equations hold in the whole picture
    bool conjugate = false;     // those of the complex conjugate do: conj(z)² + c, the tricorn
    int criticalPoints = 0;     // the most distinct ones in the picture; -1: not counted
    double determinant = 0;     // det J at the start, at the centre
    std::vector<double> start;  // at the centre
    bool startMoves = false;    // a critical point followed as it moves with the parameters
    std::string label;          // a few words: "one of 2 critical orbits"
    std::string sentence;       // why
};

// Of the picture with this centre and these half sides in the units of its first two axes. Whether
// the start is critical is asked at 25 points of the picture; Cauchy-Riemann for the planar quartic
// is exact, by its coefficients, and for other maps asked at points.
CatalogueBadge catalogueBadge(const OrbitProgram& program, const double* centre, double halfWidth,
                              double halfHeight);

}  // namespace versorium
