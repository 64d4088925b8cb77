// SPDX-License-Identifier: MIT
#include "scene/properties.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "io/document.h"
#include "scene/animation.h"
#include "scene/numbers.h"

namespace versorium {
namespace {

// Scenes that between them have every value: each map, one of them with one of everything.
std::vector<Scene> scenesOfAllKinds() {
    std::vector<Scene> scenes;
    for (const MapKernels& map : catalogue()) scenes.push_back(sceneOf(map));
    Scene whole = sceneOf(*findMap("shape-modulus"));
    whole.layers.resize(2);
    whole.layers[1].sources = {"leaf", "#102030"};
    whole.ensemble.roots.emplace();
    whole.ensemble.roots->shapeBox = false;
    whole.ensemble.ranges.push_back({"alpha", 1, 2});
    whole.ensemble.roots->draw.arrangement = RootArrangement::clustered;
    scenes.push_back(whole);
    Scene disc = sceneOf(*findMap("quadratic"));
    disc.ensemble.discs.push_back({"c", 0, 0, 0.5});
    scenes.push_back(disc);
    return scenes;
}

bool isNumber(const SceneProperty& property) {
    return property.kind == ValueKind::number || property.kind == ValueKind::whole;
}

// Another value that it may have.
Json otherValue(const Scene& scene, const SceneProperty& property) {
    const Json now = property.get(scene);
    if (property.kind == ValueKind::toggle) return !now.get<bool>();
    if (property.kind == ValueKind::word) {
        for (const std::string& word : property.words)
            if (!now.is_string() || word != now.get<std::string>()) return word;
        return now;
    }
    if (!isNumber(property) || !now.is_number()) return now;
    const double value = now.get<double>();
    const double other = value + 1 <= property.high ? value + 1 : value - 1;
    return other >= property.low ? Json(other) : Json(0.5 * (property.low + property.high));
}

TEST(Properties, AreDescribedInFull) {
    for (const Scene& scene : scenesOfAllKinds()) {
        std::set<std::string> paths;
        for (const SceneProperty& property : propertiesOf(scene)) {
            const std::string where = scene.map + " " + property.path;
            EXPECT_TRUE(paths.insert(property.path).second) << where;
            EXPECT_FALSE(property.help.empty()) << where;
            EXPECT_TRUE(property.get) << where;
            EXPECT_TRUE(property.set) << where;
            if (isNumber(property)) {
                EXPECT_LT(property.low, property.high) << where;
            }
            EXPECT_LE(property.sliderLow, property.sliderHigh) << where;
            if (property.logarithmic) {
                EXPECT_GT(property.sliderLow, 0) << where;
            }
            if (property.kind == ValueKind::word) {
                EXPECT_FALSE(property.words.empty()) << where;
            }
        }
    }
}

TEST(Properties, TakeTheirOwnValueAndKeepItThroughJson) {
    for (const Scene& scene : scenesOfAllKinds()) {
        const Json before = sceneToJson(scene);
        for (const SceneProperty& property : propertiesOf(scene)) {
            Scene same = scene;
            const Status status = setProperty(same, property, property.get(scene));
            EXPECT_TRUE(status.ok()) << scene.map << " " << status.message();
            const bool start = property.path.starts_with("z.") || property.path.starts_with("q.");
            if (!start) {
                EXPECT_EQ(sceneToJson(same), before) << scene.map << " " << property.path;
            }
        }
    }
}

TEST(Properties, ThatAreSetComeBackFromJson) {
    for (const Scene& scene : scenesOfAllKinds())
        for (const SceneProperty& property : propertiesOf(scene)) {
            if (property.kind == ValueKind::group) continue;
            const Json wanted = otherValue(scene, property);
            Scene changed = scene;
            if (!setProperty(changed, property, wanted).ok()) continue;  // not beside the others
            const Expected<Scene> read = sceneFromJson(sceneToJson(changed));
            ASSERT_TRUE(read) << property.path << ": " << read.status().message();
            const auto again = propertyNamed(*read, property.path);
            ASSERT_TRUE(again) << property.path;
            EXPECT_EQ(again->get(*read), property.get(changed)) << scene.map << property.path;
        }
}

TEST(Properties, RefuseWhatLiesOutsideWithPathAndRange) {
    for (const Scene& scene : scenesOfAllKinds())
        for (const SceneProperty& property : propertiesOf(scene)) {
            Scene changed = scene;
            const auto refuse = [&](const Json& value) {
                const Status status = property.set(changed, value, property.path);
                ASSERT_FALSE(status.ok()) << scene.map << " " << property.path << " " << value;
                EXPECT_TRUE(status.message().starts_with(property.path)) << status.message();
                EXPECT_EQ(sceneToJson(changed), sceneToJson(scene)) << property.path;
            };
            if (isNumber(property)) {
                refuse("a text");
                if (property.high < 1e300) {
                    refuse(property.high * 2 + 1);
                    Status status = property.set(changed, property.high * 2 + 1, property.path);
                    EXPECT_NE(status.message().find(formatNumber(property.high)), std::string::npos)
                        << status.message();
                }
            } else if (property.kind == ValueKind::word || property.kind == ValueKind::toggle ||
                       property.kind == ValueKind::numbers) {
                refuse("no such word");
            }
        }
}

TEST(Properties, StandInTheSchema) {
    const Json schema = sceneSchema();
    for (const Scene& scene : scenesOfAllKinds()) {
        const Json json = sceneToJson(scene);
        for (auto item = json.begin(); item != json.end(); ++item)
            EXPECT_TRUE(schema["properties"].contains(item.key())) << item.key();
    }
    Scene whole = sceneOf(*findMap("shape-modulus"));
    for (const SceneProperty& property : propertiesOf(whole)) {
        if (property.path.find('[') != std::string::npos) continue;
        const Json* at = &schema;
        std::size_t begin = 0;
        while (at && begin <= property.path.size()) {
            const std::size_t dot = std::min(property.path.find('.', begin), property.path.size());
            const std::string key = property.path.substr(begin, dot - begin);
            at = at->contains("properties") && (*at)["properties"].contains(key)
                     ? &*(*at)["properties"].find(key)
                     : nullptr;
            begin = dot + 1;
        }
        if (numberNamed(whole, property.path) || whole.lists.contains(property.path) ||
            whole.parameters.contains(property.path))
            continue;  // of the map: under "parameters", "start" and "lists"
        ASSERT_TRUE(at) << property.path;
        EXPECT_EQ((*at)["description"], std::string(property.help)) << property.path;
    }
}

TEST(Properties, AreReachedBySet) {
    for (const Scene& scene : scenesOfAllKinds())
        for (const SceneProperty& property : propertiesOf(scene)) {
            if (property.kind == ValueKind::group || property.kind == ValueKind::other) continue;
            Json value = otherValue(scene, property);
            Scene direct = scene;
            if (!setProperty(direct, property, value).ok()) continue;
            std::string text = value.is_string() ? value.get<std::string>() : value.dump();
            Scene assigned = scene;
            const Status status = assign(assigned, {property.path, text});
            ASSERT_TRUE(status.ok()) << status.message();
            EXPECT_EQ(sceneToJson(assigned), sceneToJson(direct)) << property.path;
        }
}

TEST(Properties, AreNamedByTheirLastPartAndOldNames) {
    const Scene scene = sceneOf(*findMap("shape-modulus"));
    const std::pair<const char*, const char*> names[] = {{"height", "slice.height"},
                                                         {"palette", "colour.palette"},
                                                         {"radius", "trap.radius"},
                                                         {"shape", "shape.source"},
                                                         {"centre0", "slice.center[0]"},
                                                         {"escape test", "escape_test"},
                                                         {"alpha", "alpha"},
                                                         {"roots[1].power", "roots[1].power"},
                                                         {"parameters.alpha", "alpha"},
                                                         {"lists.roots", "roots"},
                                                         {"center_low", "slice.center_low"}};
    for (const auto& [name, path] : names) {
        const auto found = propertyNamed(scene, name);
        ASSERT_TRUE(found) << name;
        EXPECT_EQ(found->path, path);
    }
    EXPECT_FALSE(propertyNamed(scene, "beauty"));
    EXPECT_FALSE(propertyNamed(scene, "roots[9].power"));
    EXPECT_EQ(nearestNames(scene, "iteratons").front(), "iterations");
    EXPECT_EQ(nearestNames(scene, "hieght").front(), "slice.height");
    EXPECT_TRUE(nearestNames(scene, "qqqqqqqqqqqqqqqq").empty());
}

TEST(Properties, ThatMoveAreThoseOfAnAnimation) {
    for (const Scene& scene : scenesOfAllKinds())
        for (const std::string& name : movingNames(scene)) {
            const auto value = movingValue(scene, name);
            ASSERT_TRUE(value) << name;
            Scene moved = scene;
            EXPECT_TRUE(setMovingValue(moved, name, *value)) << name;
            EXPECT_TRUE(setMovingValue(moved, name, 1e308)) << name;
            EXPECT_TRUE(sceneFromJson(sceneToJson(moved))) << name;
        }
}

TEST(Properties, OfGroupsAndItemsAreThoseThatMatterNow) {
    Scene scene = sceneOf(*findMap("quadratic"));
    scene.layers.resize(2);
    scene.ensemble.discs.push_back({"c", 0, 0, 0.5});
    const auto has = [&](const char* group, const char* path) {
        const SceneProperties shown = shownProperties(scene, group);
        return std::any_of(shown.begin(), shown.end(),
                           [&](const SceneProperty& one) { return one.path == path; });
    };
    EXPECT_TRUE(has("layers[1]", "layers[1].x"));
    EXPECT_FALSE(has("layers[1]", "layers[0].x"));
    EXPECT_FALSE(has("layers[1]", "layers[1].frame")) << "it has one frame";
    EXPECT_TRUE(has("ensemble.discs[0]", "ensemble.discs[0].center[1]"));
    EXPECT_TRUE(has("colour", "colour.palette"));
    EXPECT_FALSE(has("colour", "colour.escaped.start"));
    scene.colour.rule = ColourRule::gradient;
    EXPECT_FALSE(has("colour", "colour.palette"));
    EXPECT_TRUE(has("colour", "colour.escaped.start"));
}

TEST(Properties, HaveTheDefaultOfTheMap) {
    const Scene scene = sceneOf(*findMap("quadratic"));
    Scene changed = scene;
    for (const char* name : {"iterations", "slice.height", "slice.center[0]", "c.re"}) {
        const auto property = propertyNamed(scene, name);
        ASSERT_TRUE(property) << name;
        ASSERT_TRUE(setProperty(changed, *property, otherValue(scene, *property)).ok()) << name;
        EXPECT_EQ(defaultOf(changed, *property), property->get(scene)) << name;
    }
}

}  // namespace
}  // namespace versorium
