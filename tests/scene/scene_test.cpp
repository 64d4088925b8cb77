// SPDX-License-Identifier: MIT
#include "scene/scene.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>

#include "scene/numbers.h"

namespace versorium {
namespace {

std::string faultOf(const std::string& text) {
    const Expected<Json> json = parseJson(text);
    if (!json) return json.status().message();
    const Expected<Scene> scene = sceneFromJson(*json);
    return scene ? "" : scene.status().message();
}
// The message begins with the path of the fault.
void expectFault(const std::string& text, const std::string& beginning) {
    const std::string message = faultOf(text);
    EXPECT_EQ(message.substr(0, beginning.size()), beginning) << text << "\n" << message;
}

void expectRoundTrip(const Scene& scene, const std::string& name) {
    const Json json = sceneToJson(scene);
    const std::string text = printJson(json);
    const Expected<Json> parsed = parseJson(text);
    ASSERT_TRUE(parsed.ok()) << name << ": " << parsed.status().message();
    const Expected<Scene> again = sceneFromJson(*parsed);
    ASSERT_TRUE(again.ok()) << name << ": " << again.status().message();
    EXPECT_EQ(printJson(sceneToJson(*again)), text) << name;
    EXPECT_EQ(again->parameters, scene.parameters) << name;
    EXPECT_EQ(again->lists, scene.lists) << name;
    EXPECT_EQ(again->slice, scene.slice) << name;
    EXPECT_EQ(again->colour, scene.colour) << name;
    EXPECT_EQ(again->shape, scene.shape) << name;
    EXPECT_EQ(again->trap, scene.trap) << name;
    EXPECT_EQ(again->criticalStart, scene.criticalStart) << name;
    EXPECT_EQ(again->escapeRadius, scene.escapeRadius) << name;
    EXPECT_EQ(again->iterations, scene.iterations) << name;
}

TEST(Scene, OfEveryMapReadsBackExactly) {
    for (const MapKernels& map : catalogue())
        expectRoundTrip(sceneOf(map), std::string(map.info.name));
}

TEST(Scene, OfTypedFormulasReadBackExactly) {
    for (const char* text :
         {"z^2+c", "z^3 - a*z + conj(c); a: real = 0.5 in [0, 4]", "x' = 1 - a*x^2 + y, y' = b*x",
          "q^2 + c; c = 0.1 + 0.2j", "r*x*(1-x)", "z^2 - 1"}) {
        const Expected<Scene> scene = sceneOfMap(text);
        ASSERT_TRUE(scene.ok()) << scene.status().message();
        expectRoundTrip(*scene, text);
        const Json json = sceneToJson(*scene);
        EXPECT_EQ(json["map"], "formula");
        const Expected<Scene> again = sceneFromJson(json);
        EXPECT_EQ(again->formula, scene->formula) << text;
    }
    Scene scene = *sceneOfMap("z^3 + a*z + b");
    setNumber(scene, *numberNamed(scene, "a.im"), 0.25);
    const Expected<Scene> again = sceneFromJson(sceneToJson(scene));
    EXPECT_EQ(again->parameters.at("a"), (std::vector<double>{1, 0.25}));
}

TEST(Scene, SaysWhatIsWrongWithAFormula) {
    expectFault(R"({"map": "formula"})", "formula: is missing");
    expectFault(R"({"map": "formula", "formula": 3})", "formula: ");
    expectFault(R"({"map": "quadratic", "formula": "z^2"})", "formula: stands beside");
    expectFault(R"({"map": "formula", "formula": "z^2 + * c"})", "formula, character 7: ");
    expectFault(R"({"map": "formula", "formula": "z^2 + c", "parameters": {"d": [0, 0]}})",
                "parameters.d");
    expectFault(R"({"map": "formula", "formula": "z^2 + c", "parameters": {"c": 1}})",
                "parameters.c");
    EXPECT_NE(sceneOfMap("nonsense").status().message().find("versorium maps"), std::string::npos);
    EXPECT_NE(sceneOfMap("z^2 + * c").status().message().find("\n          ^"), std::string::npos);
}

TEST(Scene, OfEveryPresetReadsBackExactly) {
    const auto names = presetNames();
    EXPECT_FALSE(names.empty());
    for (const std::string& name : names) {
        const Expected<Scene> scene = presetNamed(name);
        ASSERT_TRUE(scene.ok()) << scene.status().message();
        expectRoundTrip(*scene, name);
    }
    EXPECT_NE(presetNamed("no-such-preset").status().message().find("mandelbrot"),
              std::string::npos);
}

// Doubles of any kind survive: their shortest decimal form reads back to the same bits.
TEST(Scene, KeepsEveryBitOfItsNumbers) {
    for (double value : {0.1, -0.0, 5e-324, 2.2250738585072014e-308, 1.0 / 3, 1e300,
                         -0.74364388703715870475, 123456789.12345679}) {
        Scene scene = sceneOf(*findMap("quadratic"));
        scene.parameters["c"] = {value, -value};
        scene.start = {value, 1};
        scene.slice.centre = {value, -value};
        const Expected<Scene> again = sceneFromJson(*parseJson(printJson(sceneToJson(scene))));
        ASSERT_TRUE(again.ok()) << again.status().message();
        const double read[4] = {again->parameters.at("c")[0], -again->parameters.at("c")[1],
                                again->start[0], again->slice.centre[0]};
        for (double number : read) EXPECT_EQ(std::memcmp(&number, &value, 8), 0) << value;
    }
}

TEST(Scene, EverythingAtOnceReadsBack) {
    Scene scene = sceneOf(*findMap("shape-modulus"));
    scene.slice.axes = {{{{"q.w", 0.6}, {"q.x", 0.8}}},
                        {{{"alpha", 10}, {"roots[2].power", -1}}},
                        {{{"beta", 0.5}}}};
    scene.slice.origin = {{"alpha", 40}, {"roots[1].y", -0.25}};
    scene.slice.centre = {0.1, 0.2, 0.3};
    scene.slice.centreLow = {1e-18, -1e-19, 0};
    scene.slice.height = 1e-9;
    scene.shape = {"union(sphere(0.3), box(0.1, 0.2, 0.3))", 32, 2.5, Outside::border, true};
    scene.escapeRadius = 12.5;
    scene.escapeTest = EscapeTest::last;
    scene.iso = -0.25;
    scene.trap = {Trap::Kind::circle, {0.5, 0.25, 0.125}, 0.75, 1.5};
    scene.colour = {ColourRule::gradient, FieldName::trap, "viridis",     {}, true,
                    ScaleKind::log,       {0.5, 2},        SetName::none, {}, {},
                    Smoothing::logLog,    SetName::solid,  "#ff8000",     2.5};
    scene.aspect = 1.5;
    scene.samples = 4;
    addAsset(scene, {"grid.f3d", {1, 2, 3, 250}});
    expectRoundTrip(scene, "everything");
    const Expected<Scene> again = sceneFromJson(sceneToJson(scene));
    ASSERT_TRUE(again.ok());
    ASSERT_EQ(again->assets.size(), 1u);
    EXPECT_EQ(again->assets.begin()->second->bytes, scene.assets.begin()->second->bytes);
    EXPECT_EQ(again->samples, 4);
    EXPECT_EQ(again->aspect, 1.5);
    EXPECT_EQ(again->iso, -0.25);
    EXPECT_EQ(again->escapeTest, EscapeTest::last);
}

// A start at a critical point is another start than numbers.
TEST(Scene, StartsAtACriticalPoint) {
    const Expected<Scene> scene = sceneFromJson(*parseJson(
        R"({"map": "cubic", "start": {"critical": 1}, "slice": {"axes": [{"a.re": 1}, {"a.im": 1}]}})"));
    ASSERT_TRUE(scene.ok()) << scene.status().message();
    EXPECT_EQ(scene->criticalStart, 1);
    expectRoundTrip(*scene, "critical");
    expectFault(R"({"map": "cubic", "start": {"critical": 1}})", "start: ");
    expectFault(R"({"map": "cubic", "start": {"critical": -1}})", "start.critical: ");
    expectFault(R"({"map": "cubic", "start": {"point": 1}})", "start: ");
}

TEST(Scene, RefusesUnknownAndDoubleKeys) {
    expectFault(R"({"iteration": 5})", "iteration: unknown key");
    expectFault(R"({"slice": {"heigth": 5}})", "slice.heigth: unknown key");
    expectFault(R"({"parameters": {"alpha": 5}})", "parameters.alpha: unknown key");
    expectFault(R"({"colour": {"escaped": {"begin": [0, 0, 0]}}})",
                "colour.escaped.begin: unknown key");
    expectFault(R"({"map": "newton", "lists": {"poles": {}}})", "lists.poles: unknown key");
    expectFault(R"({"map": "newton", "lists": {"roots": {"roots": [{"q": [1], "m": 2}]}}})",
                "lists.roots.roots[0].m: unknown key");
    expectFault(R"({"slice": {"height": 5, "height": 6}})", "slice.height: the key stands twice");
    expectFault(R"({"map": "julia"})", "map: no map is named");
    expectFault(R"({"versorium": 2})", "versorium: version 2 is newer");
    expectFault(R"({"versorium": 0})", "versorium: ");
    expectFault(R"([1, 2])", "");
    EXPECT_NE(faultOf("[1, 2]"), "");
    EXPECT_NE(faultOf("7"), "");
    EXPECT_NE(faultOf("null"), "");
}

TEST(Scene, RefusesWhatIsNoNumberOrTooLarge) {
    expectFault(R"({"iso": NaN})", "not JSON");
    expectFault(R"({"iso": Infinity})", "not JSON");
    expectFault(R"({"parameters": {"c": [1e999, 0]}})", "");
    EXPECT_NE(faultOf(R"({"parameters": {"c": [1e999, 0]}})"), "");
    expectFault(R"({"parameters": {"c": [1e308, 0]}})", "parameters.c: ");
    expectFault(R"({"iterations": 10000001})", "iterations: ");
    expectFault(R"({"iterations": -1})", "iterations: ");
    expectFault(R"({"iterations": 1.5})", "iterations: 1.5 is not a whole number");
    expectFault(R"({"iterations": "many"})", "iterations: a number");
    expectFault(R"({"escape_radius": -1})", "escape_radius: ");
    expectFault(R"({"escape_radius": 1e308})", "escape_radius: ");
    expectFault(R"({"escape_radius": "large"})", "escape_radius: ");
    expectFault(R"({"escape_radius": null})", "escape_radius: ");
    expectFault(R"({"slice": {"height": 0}})", "slice.height: ");
    expectFault(R"({"slice": {"height": -1}})", "slice.height: ");
    expectFault(R"({"aspect": 0})", "aspect: ");
    expectFault(R"({"samples": 9})", "samples: ");
    expectFault(R"({"trap": {"kind": "square"}})", "trap.kind: ");
    expectFault(R"({"colour": {"field": "beauty"}})", "colour.field: ");
    expectFault(R"({"colour": {"outline_colour": "white"}})", "colour.outline_colour: ");
    expectFault(R"({"colour": {"escaped": {"start": [0, 0, 1.5]}}})", "colour.escaped.start: ");
    expectFault(R"({"colour": {"escaped": {"exponent": 0}}})", "colour.escaped.exponent: ");
    // A JSON value that no text gives.
    Json json = sceneToJson(sceneOf(*findMap("quadratic")));
    const double nan = std::numeric_limits<double>::quiet_NaN();
    for (const char* path : {"/parameters/c/0", "/start/0", "/slice/center/0", "/slice/height",
                             "/iso", "/trap/point/0", "/slice/axes/0/z.re"}) {
        Json odd = json;
        odd[Json::json_pointer(path)] = nan;
        EXPECT_FALSE(sceneFromJson(odd).ok()) << path;
    }
}

TEST(Scene, RefusesWrongWidths) {
    expectFault(R"({"parameters": {"c": [1, 2, 3]}})", "parameters.c: a list of 2 numbers");
    expectFault(R"({"parameters": {"c": 1}})", "parameters.c: a list of 2 numbers");
    expectFault(R"({"parameters": {"c": ["1", 2]}})", "parameters.c: ");
    expectFault(R"({"parameters": 5})", "parameters: ");
    expectFault(R"({"start": [1]})", "start: a list of 2 numbers");
    expectFault(R"({"slice": {"center": [1]}})", "slice.center: a list of 2 numbers");
    expectFault(R"({"slice": {"axes": []}})", "slice.axes: ");
    expectFault(R"({"slice": {"axes": [{}]}})", "slice.axes[0]: ");
    expectFault(R"({"slice": {"axes": [{"z.re": 0}]}})", "slice.axes[0].z.re: ");
    expectFault(R"({"slice": {"axes": [{"z.x": 1}]}})", "slice.axes[0]: the map \"quadratic\" has");
    expectFault(R"({"slice": {"axes": [{"c.re": 1}, {"c.im": 1}, {"z.re": 1}, {"z.im": 1}]}})",
                "slice.axes: ");
    expectFault(R"({"slice": {"origin": {"c": 1}}})", "slice.origin: ");
    expectFault(R"({"slice": {"origin": {"c.re": "1"}}})", "slice.origin: ");
    expectFault(R"({"trap": {"point": []}})", "trap.point: ");
    expectFault(R"({"colour": {"range": [1]}})", "colour.range: ");
    expectFault(R"({"map": "newton", "lists": {"roots": {"roots": [{"q": [1, 2, 3, 4, 5]}]}}})",
                "lists.roots.roots[0].q: ");
    expectFault(R"({"map": "newton", "lists": {"roots": {"roots": [{"power": 2}]}}})",
                "lists.roots.roots[0]: ");
    expectFault(R"({"map": "newton", "lists": {"roots": {"roots": 7}}})", "lists.roots.roots: ");
}

TEST(Scene, RefusesDeepNestingAndTooMuch) {
    std::string deep = R"({"slice": )";
    for (int i = 0; i < 100; ++i) deep += "[";
    EXPECT_NE(faultOf(deep).find("levels deep"), std::string::npos);
    std::string many = R"({"map": "newton", "lists": {"roots": {"roots": [)";
    for (std::size_t i = 0; i <= kMostRoots; ++i) many += R"({"q":[1]},)";
    many.back() = ']';
    expectFault(many + "}}}", "lists.roots.roots: a list of at most 4096");
}

TEST(Scene, RefusesAssetsThatAreNotWhatTheySay) {
    Scene scene = sceneOf(*findMap("shape-modulus"));
    addAsset(scene, {"grid.f3d", {1, 2, 3}});
    Json json = sceneToJson(scene);
    json["assets"].begin().value()["data"] = "AAAA";
    EXPECT_NE(sceneFromJson(json).status().message().find("SHA-256"), std::string::npos);
    json["assets"].begin().value()["data"] = "A?==";
    EXPECT_FALSE(sceneFromJson(json).ok());
    json["assets"].begin().value()["data"] = 7;
    EXPECT_FALSE(sceneFromJson(json).ok());
    json["assets"] = Json::array();
    EXPECT_FALSE(sceneFromJson(json).ok());
}

// Every number has one name, and the name leads back to it.
TEST(Numbers, AreReachedByName) {
    for (const MapKernels& map : catalogue()) {
        Scene scene = sceneOf(map);
        double value = 0.5;
        for (int k = 0; k < map.dimension + map.parameters; ++k) {
            const std::string name = k < map.dimension
                                         ? stateComponent(map.info, k)
                                         : parameterComponent(map.info, k - map.dimension);
            const auto number = numberNamed(scene, name);
            ASSERT_TRUE(number) << map.info.name << " " << name;
            setNumber(scene, *number, value);
            EXPECT_EQ(numberValue(scene, *number), value);
            EXPECT_NE(numberNames(scene).find(name), std::string::npos);
            value += 1;
        }
        for (int k = 0; k < map.dimension; ++k)
            EXPECT_EQ(scene.start[static_cast<std::size_t>(k)], 0.5 + k);
        EXPECT_FALSE(numberNamed(scene, "no.such"));
    }
    Scene scene = sceneOf(*findMap("quaternion-rational"));
    const auto number = numberNamed(scene, "roots[2].y");
    ASSERT_TRUE(number);
    setNumber(scene, *number, 7);
    EXPECT_EQ(scene.lists.at("roots").roots[2].q[2], 7);
    for (const char* name : {"roots[4].y", "roots[-1].y", "roots[].y", "roots[2].re", "roots[2]",
                             "poles[0].y", "roots[99999999999].y", "roots]2[.y", "[0].y"})
        EXPECT_FALSE(numberNamed(scene, name)) << name;
}

// The schema writes every default out, and knows every key that a scene has.
TEST(Schema, KnowsEveryKeyOfAScene) {
    const Json schema = sceneSchema();
    const Json scene = sceneToJson(sceneOf(*findMap("shape-modulus")));
    for (auto item = scene.begin(); item != scene.end(); ++item) {
        ASSERT_TRUE(schema["properties"].contains(item.key())) << item.key();
        EXPECT_TRUE(schema["properties"][item.key()].contains("description")) << item.key();
    }
    // And "formula".
    EXPECT_EQ(schema["properties"]["map"]["enum"].size(), catalogue().size() + 1);
    EXPECT_TRUE(schema["properties"].contains("formula"));
    EXPECT_EQ(schema["x-maps"].size(), catalogue().size());
}

}  // namespace
}  // namespace versorium
