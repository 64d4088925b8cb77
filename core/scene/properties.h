// SPDX-License-Identifier: MIT
#pragma once
// The one table of a scene's values (scene/property.h). The order of a table is that of the JSON.
// Parts that stand in lists or that depend on the map (parameters, components of the starting
// point, roots, axes) are made from the scene.

#include <optional>
#include <string>
#include <vector>

#include "scene/property.h"
#include "scene/scene.h"

namespace versorium {

using SceneProperty = Property<Scene>;
using SceneProperties = PropertyTable<Scene>;

// The members of a scene's JSON but for its version, map, formula and files.
const SceneProperties& sceneTable();

// Every value that applies to this scene, groups before what they hold: "colour", "colour.rule" …;
// numbers of the map by their names ("c", "c.re", "z.im", "roots[0].power").
SceneProperties propertiesOf(const Scene& scene);
// Those of one group ("colour") or of an item of a list ("layers[1]") that matter as the scene is
// now.
SceneProperties shownProperties(const Scene& scene, const std::string& group);

// By its path, by the last part of one ("height", "palette"), or by its alias.
std::optional<SceneProperty> propertyNamed(const Scene& scene, const std::string& name);
// At most three names that look like this one, nearest first: for "did you mean".
std::vector<std::string> nearestNames(const Scene& scene, const std::string& name);
// That there is no such value, and what may have been meant.
Status unknownValue(const Scene& scene, const std::string& name);

// What the value is in a new scene of the same map.
Json defaultOf(const Scene& scene, const SceneProperty& property);
// Sets a value and checks the scene as a whole. The scene is unchanged where it fails.
Status setProperty(Scene& scene, const SceneProperty& property, const Json& value);

// What holds between values: names of numbers that the map has, and the like.
Status checkScene(const Scene& scene);

// Tables of the parts of a scene.
const PropertyTable<Layer>& layerTable();
const PropertyTable<Colouring>& colourTable();
const PropertyTable<TrapSpec>& trapTable();
const PropertyTable<ShapeSpec>& shapeTable();
const PropertyTable<SliceSpec>& sliceTable();
const PropertyTable<EnsembleSpec>& ensembleTable();
const PropertyTable<EnsembleRoots>& ensembleRootsTable();
const PropertyTable<ModulationSpec>& modulationTable();
// Parameters, the starting point and lists of roots, which depend on the map.
SceneProperty parametersProperty();
SceneProperty startProperty();
SceneProperty listsProperty();

}  // namespace versorium
