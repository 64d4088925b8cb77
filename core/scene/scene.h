// SPDX-License-Identifier: MIT
#pragma once
// Scene: the one document. It says everything that a picture follows from: the map and what is
// bound to it, the slice, what is measured and how it is coloured. A plain aggregate with defaults
// and value semantics: undo is a list of scenes, a link is a scene, a PNG carries a scene.

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/json.h"
#include "colour/rules.h"
#include "colour/scale.h"
#include "fields/evaluate.h"
#include "geometry/roots.h"
#include "maps/catalogue.h"
#include "maps/formula_map.h"
#include "scene/ensemble.h"
#include "scene/modulation.h"

namespace versorium {

// Immutable bytes that a scene needs: a mesh, a grid or an image, named by their content.
struct Asset {
    std::string name;  // the file's own name; its ending says what it is
    std::vector<unsigned char> bytes;
};
// By SHA-256. Bytes are never copied: whoever needs them shares them.
using Assets = std::map<std::string, std::shared_ptr<const Asset>>;

struct SliceAxis {
    // Names of numbers ("c.re", "z.im", "power", "roots[2].x") with their weights.
    std::vector<std::pair<std::string, double>> terms;
    friend bool operator==(const SliceAxis&, const SliceAxis&) = default;
};

struct SliceSpec {
    std::vector<SliceAxis> axes;
    // Numbers on an axis start from 0 unless they stand here; all others keep their values.
    std::map<std::string, double> origin;
    std::vector<double> centre, centreLow;  // one for each axis
    double height = 4;
    friend bool operator==(const SliceSpec&, const SliceSpec&) = default;
};

struct ShapeSpec {
    // An analytic shape as text, the name of a built-in mesh ("bunny"), or "asset:" and a SHA-256.
    std::string source = "sphere(0.35)";
    int resolution = 64;             // nodes along an edge of the grid made of a mesh
    double padding = 6;              // free cells around it
    std::optional<Outside> outside;  // empty: border for a loaded grid, else distance
    bool zFastest = false;           // a loaded grid runs along z first
    // Of a picture: inside is what is darker than this share of white, or as opaque as it at least.
    double threshold = 0.5;
    bool byAlpha = false;  // opacity decides, not lightness
    bool invert = false;   // inside is what would be outside
    friend bool operator==(const ShapeSpec&, const ShapeSpec&) = default;
};

struct TrapSpec {
    Trap::Kind kind = Trap::Kind::point;  // a line goes through `point` at `angle`
    std::vector<double> point{0, 0};
    double radius = 1, angle = 0;
    friend bool operator==(const TrapSpec&, const TrapSpec&) = default;
};

// A set that is coloured or outlined.
enum class SetName { none, membership, solid };
template <>
struct EnumWords<SetName> {
    static constexpr std::array<std::string_view, 3> table{"none", "membership", "solid"};
};
// The field that is 1 in the set.
inline std::optional<FieldName> fieldOf(SetName set) {
    if (set == SetName::none) return std::nullopt;
    return set == SetName::solid ? FieldName::solid : FieldName::membership;
}

// Which iterates are tested: the first one outside counts, or only the last one (A eq 12).
enum class EscapeTest { first, last };
template <>
struct EnumWords<EscapeTest> {
    static constexpr std::array<std::string_view, 2> table{"first", "last"};
};

struct Colouring {
    ColourRule rule = ColourRule::palette;
    FieldName field = FieldName::smoothEscape;
    std::string palette = "versorium";  // a built-in one, or the name of `ownPalette`
    Json ownPalette;                    // a palette (colour/palette.h) of the scene's own, or null
    bool reverse = false;
    std::optional<ScaleKind> scale;          // empty: the field's own
    std::vector<double> range;               // low and high; empty: the field's own
    SetName interior = SetName::membership;  // the set in the palette's interior colour
    Gradient escaped{{0.02, 0.03, 0.08, 1}, {1, 0.95, 0.8, 1}, 1};
    Gradient attracted{{0, 0, 0, 1}, {0, 0, 0, 1}, 1};
    Smoothing smoothing = Smoothing::ratio;
    SetName outline = SetName::none;
    std::string outlineColour = "#ffffff";
    double outlineWidth = 1;            // in line widths of the medium
    std::vector<double> contours = {};  // levels of `field` along which the same line runs
    friend bool operator==(const Colouring&, const Colouring&) = default;
};

// An image behind the fractal or in front of it (A section 5.3), of which the fractal's own alpha
// lets something through. Lengths are in heights of the picture.
struct Layer {
    // "leaf", the program's own; "#rrggbb", a sheet of one colour that fills the picture; or
    // "asset:" and the SHA-256 of an image. Several are the frames of a sequence.
    std::vector<std::string> sources{"leaf"};
    double frame = 0;  // of a sequence; it begins again after the last one
    bool front = false;
    double x = 0, y = 0;  // the image's middle from the picture's, to the right and up
    double scale = 1;     // the image's height, above 0
    double opacity = 1;   // in [0, 1]
    friend bool operator==(const Layer&, const Layer&) = default;
};
inline constexpr const char* kLeafLayer = "leaf";
inline constexpr std::size_t kMostLayers = 8;
inline constexpr std::size_t kMostFrames = 1000;

struct Scene {
    static constexpr int kVersion = 1;
    std::string map = "quadratic";              // of the catalogue, or "formula"
    std::shared_ptr<const FormulaMap> formula;  // what was typed, where the map is "formula"
    std::map<std::string, std::vector<double>> parameters;  // every one of the map's
    std::vector<double> start;                              // dimension numbers
    std::optional<int> criticalStart;                       // instead of `start`
    std::map<std::string, RootList> lists;
    ShapeSpec shape;
    ModulationSpec alphaOverSpace, betaOverSpace;
    SliceSpec slice;
    int iterations = 200;
    std::optional<double> escapeRadius;  // empty: the map's own
    EscapeTest escapeTest = EscapeTest::first;
    double iso = 0;  // of the field `solid`
    TrapSpec trap;
    Colouring colour;
    EnsembleSpec ensemble;
    std::vector<Layer> layers;  // from the bottom up
    double aspect = 1;          // width / height of the picture
    int samples = 2;            // along each side of a pixel, averaged in linear light
    Assets assets;
};

inline constexpr int kMostIterations = 10000000;
inline constexpr int kMostSamples = 8;
inline constexpr std::size_t kMostContours = 100;
inline constexpr std::size_t kMostRoots = 4096;
inline constexpr std::size_t kMostAssetBytes = 32u << 20;

const MapKernels& mapOf(const Scene& scene);
// The map's own view: its dynamical plane with its default parameters.
Scene sceneOf(const MapKernels& map);
// The name of a map of the catalogue, or a formula. ErrorKind::usage where it is neither, with a ^
// below the character of a formula.
Expected<Scene> sceneOfMap(const std::string& nameOrFormula);

// Strict: ErrorKind::data with the path of the fault. Unknown keys, NaN and newer versions are
// refused; what is absent takes the map's default.
Expected<Scene> sceneFromJson(const Json& value);
// Every default explicit.
Json sceneToJson(const Scene& scene);
// The same without the assets' bytes: they are named by their SHA-256, so equal texts are equal
// scenes.
Json sceneBody(const Scene& scene);
// {SHA-256: {"name", "data": Base64}, …}. Reading checks every one.
Json assetsToJson(const Assets& assets);
Status assetsFromJson(const Json& value, const std::string& path, Assets& assets);

// Puts an asset in and returns its name for ShapeSpec::source.
std::string addAsset(Scene& scene, Asset asset);

// Presets, embedded: "mandelbrot", "henon", ….
std::vector<std::string> presetNames();
Expected<Scene> presetNamed(const std::string& name);

// JSON Schema (draft 2020-12) of a scene, every default written out.
Json sceneSchema();

}  // namespace versorium
