// SPDX-License-Identifier: MIT
#pragma once
// What the studio does to the ensemble of a view (scene/ensemble.h): the averages that one press
// sets up, what may be drawn at random, and the levels of contours. An ensemble is its view's own.

#include <string>
#include <utility>
#include <vector>

#include "workspace/workspace.h"

namespace versorium {

struct StudioContext;

// The field of an ensemble that a scene shows: "mean_membership", "standard_error", or empty.
std::string shownAverage(const Scene& scene);
// Shows it on a perceptual palette over its whole range, the mean with contours; empty: the map's
// own colours again. The ensemble stays.
void showAverage(Scene& scene, const std::string& field);

// The mean over members whose first list of roots is drawn at random, in the box of the shape
// where there is one. ErrorKind::usage where the map has no list, or the picture runs over it.
Status averageOverVersors(Scene& scene);
// The mean over a complex parameter from a disc around its present value; a real one from a range
// where there is no complex one. ErrorKind::usage where all are on the axes.
Status averageOverNumber(Scene& scene);
// Which number that would be: "c in a disc", "alpha in a range"; empty where there is none.
std::string averagedNumber(const Scene& scene);

// Numbers that could be drawn from a range, and complex ones that could be drawn from a disc,
// besides those that are.
std::vector<std::string> freeRanges(const Scene& scene);
std::vector<std::string> freeDiscs(const Scene& scene);
// From about the present value.
void addRange(Scene& scene, const std::string& name);
void addDisc(Scene& scene, const std::string& name);

// Levels by name, to choose from, and what stands for the levels of a scene.
const std::vector<std::pair<std::string, std::vector<double>>>& contourChoices();
// "0.1, 0.5" and back; ErrorKind::usage where that is no list of numbers.
std::string contourText(const std::vector<double>& levels);
Expected<std::vector<double>> contoursFromText(const std::string& text);

// "Mean of 312 of 1000 sets", with what is drawn for each; empty of other pictures.
std::string describeEnsemble(const StudioContext& context, int view);

}  // namespace versorium
