// SPDX-License-Identifier: MIT
#include "io/document.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "io/png.h"
#include "scene/numbers.h"

namespace versorium {
namespace {

Status set(Scene& scene, const std::string& text) {
    const Expected<Assignment> assignment = parseAssignment(text);
    if (!assignment) return assignment.status();
    const std::string key = assignment->key;
    const Status status = assign(scene, *assignment);
    if (status.ok()) {
        EXPECT_TRUE(knowsKey(scene, key)) << key;
    }
    return status;
}
Scene with(const char* map, const std::vector<std::string>& texts) {
    Scene scene = sceneOf(*findMap(map));
    for (const std::string& text : texts) {
        const Status status = set(scene, text);
        EXPECT_TRUE(status.ok()) << status.message();
    }
    return scene;
}

TEST(Assign, EveryCommonKey) {
    const Scene view = with("quadratic", {"center=-0.75,0.1", "height=2.5", "iterations=300",
                                          "escape_radius=20", "c=-0.8,0.156", "samples=3"});
    EXPECT_EQ(view.slice.centre, (std::vector<double>{-0.75, 0.1}));
    EXPECT_EQ(view.slice.height, 2.5);
    EXPECT_EQ(view.iterations, 300);
    EXPECT_EQ(view.escapeRadius, 20);
    EXPECT_EQ(view.parameters.at("c"), (std::vector<double>{-0.8, 0.156}));
    EXPECT_EQ(view.samples, 3);
    EXPECT_EQ(with("quadratic", {"c.im=0.5"}).parameters.at("c")[1], 0.5);
    EXPECT_EQ(with("quadratic", {"iterations=1e6"}).iterations, 1000000);
    EXPECT_FALSE(with("quadratic", {"escape_radius=20", "escape_radius=auto"}).escapeRadius);

    const Scene power = with("power", {"power=2.5", "palette=viridis", "field=distance",
                                       "colour.scale=log", "range=0.1,2", "kind=circle",
                                       "outline=membership", "escape_test=last", "reverse=true"});
    EXPECT_EQ(power.parameters.at("power")[0], 2.5);
    EXPECT_EQ(power.colour.palette, "viridis");
    EXPECT_EQ(power.colour.field, FieldName::distance);
    EXPECT_EQ(power.colour.scale, ScaleKind::log);
    EXPECT_EQ(power.colour.range, (std::vector<double>{0.1, 2}));
    EXPECT_EQ(power.trap.kind, Trap::Kind::circle);
    EXPECT_EQ(power.colour.outline, SetName::membership);
    EXPECT_TRUE(power.colour.reverse);

    const Scene shape = with("shape-modulus",
                             {"alpha=6", "beta=0.02", "shift=0.1,0,-0.1,0", "shape=torus(0.3, 0.1)",
                              "outside=border", "roots[1].power=3", "roots[1].w=0.25", "drop=0"});
    EXPECT_EQ(shape.parameters.at("alpha")[0], 6);
    EXPECT_EQ(shape.parameters.at("beta")[0], 0.02);
    EXPECT_EQ(shape.parameters.at("shift"), (std::vector<double>{0.1, 0, -0.1, 0}));
    EXPECT_EQ(shape.shape.source, "torus(0.3, 0.1)");
    EXPECT_EQ(shape.shape.outside, Outside::border);
    EXPECT_EQ(shape.lists.at("roots").roots[1].power, 3);
    EXPECT_EQ(shape.lists.at("roots").roots[1].q[0], 0.25);
    const Scene typed = with("newton", {R"(roots={"roots": [{"q": [2]}, {"q": [0, 1]}]})"});
    ASSERT_EQ(typed.lists.at("roots").roots.size(), 2u);
    EXPECT_EQ(typed.lists.at("roots").roots[1].q[1], 1);

    const Scene henon = with("planar", {"g.a2=-1.4", "h.b1=0.3", "parameters.g.d=1"});
    EXPECT_EQ(henon.parameters.at("g.a2")[0], -1.4);
    EXPECT_EQ(henon.parameters.at("g.d")[0], 1);

    const Scene other = with("quadratic", {"palette=viridis", "map=burning-ship", "height=3"});
    EXPECT_EQ(other.map, "burning-ship");
    EXPECT_EQ(other.colour.palette, "viridis");
    EXPECT_EQ(other.parameters.at("c"), sceneOf(*findMap("burning-ship")).parameters.at("c"));
}

TEST(Assign, MovesTheStart) {
    EXPECT_EQ(with("quadratic", {"start=0.25,0.5"}).start, (std::vector<double>{0.25, 0.5}));
    Scene scene =
        with("quadratic", {R"(slice.axes=[{"c.re": 1}, {"c.im": 1}])", R"(start={"critical": 0})"});
    EXPECT_EQ(scene.criticalStart, 0);
    // A number of the start that is typed has to count.
    ASSERT_TRUE(set(scene, "z.re=0.5").ok());
    EXPECT_FALSE(scene.criticalStart);
    EXPECT_EQ(scene.start[0], 0.5);
}

// Points are written as lists or as formulas write them.
TEST(Assign, TakesComplexNumbersAsFormulasWriteThem) {
    const auto c = [](const char* text) {
        Scene scene = sceneOf(*findMap("quadratic"));
        EXPECT_TRUE(set(scene, text).ok()) << text;
        return scene.parameters.at("c");
    };
    using Point = std::vector<double>;
    EXPECT_EQ(c("c=-0.8+0.156i"), (Point{-0.8, 0.156}));
    EXPECT_EQ(c("c=-0.8 - 0.156*i"), (Point{-0.8, -0.156}));
    EXPECT_EQ(c("c=i"), (Point{0, 1}));
    EXPECT_EQ(c("c=-0.8"), (Point{-0.8, 0}));
    EXPECT_EQ(c("c=-0.8,0.156"), (Point{-0.8, 0.156}));
    Scene scene = sceneOf(*findMap("quadratic"));
    ASSERT_TRUE(set(scene, "center=-0.5+0.25i").ok());
    EXPECT_EQ(scene.slice.centre, (Point{-0.5, 0.25}));
    ASSERT_TRUE(set(scene, "aspect=16/9").ok());
    EXPECT_EQ(scene.aspect, 16.0 / 9);
    for (const char* text : {"c=-0.8+0.156j", "c=0,4+1", "c=x", "c=1/0"})
        EXPECT_FALSE(set(scene, text).ok()) << text;
    Scene quaternion = sceneOf(*findMap("quaternion-quadratic"));
    ASSERT_TRUE(set(quaternion, "c=-0.2 + 0.8*j").ok());
    EXPECT_EQ(quaternion.parameters.at("c"), (Point{-0.2, 0, 0.8, 0}));
}

// What is refused says the assignment and the reason, and leaves the scene as it was.
TEST(Assign, RefusesWhatMakesNoSense) {
    for (const char* text : {"colour=red",
                             "heigth=3",
                             "height=tall",
                             "height=0",
                             "height=-2",
                             "iterations=1.5",
                             "iterations=-1",
                             "iterations=99999999",
                             "c=1,2,3",
                             "c=nan,0",
                             "c=inf,0",
                             "c.re=nan",
                             "c.re=-inf",
                             "c.re=1,2",
                             "c.re=",
                             "c=1e308,0",
                             "c.re=1e308",
                             "center=0",
                             "escape_radius=nan",
                             "escape_radius=-1",
                             "escape_radius=1e999",
                             "palette=mud",
                             "map=julia",
                             "z.re=x",
                             "power=2",
                             "roots=list.p4d",
                             "samples=0",
                             "aspect=1e308",
                             "outside=border",
                             "slice=0",
                             "parameters=1",
                             "slice.axes=[]",
                             "versorium=2",
                             "field=beauty",
                             "c={\"re\": 1}",
                             "trap.point=1,2,3,4,5",
                             "iso=1e308"}) {
        Scene scene = sceneOf(*findMap("quadratic"));
        const std::string before = printJson(sceneToJson(scene));
        const Status status = set(scene, text);
        EXPECT_FALSE(status.ok()) << text;
        EXPECT_EQ(status.kind(), ErrorKind::usage) << text << ": " << status.message();
        EXPECT_NE(status.message().find(text), std::string::npos) << status.message();
        EXPECT_EQ(printJson(sceneToJson(scene)), before) << text;
    }
    EXPECT_FALSE(parseAssignment("height").ok());
    EXPECT_FALSE(parseAssignment("=3").ok());
    EXPECT_EQ(parseAssignment("shape=a=b")->value, "a=b");
}

// Every number of every map by its own name: kept to the bit, or refused; never half done.
TEST(Assign, EveryNumberTakesOddValuesOrRefusesThem) {
    for (const MapKernels& map : catalogue())
        for (int k = 0; k < map.dimension + map.parameters; ++k) {
            const std::string name = k < map.dimension
                                         ? stateComponent(map.info, k)
                                         : parameterComponent(map.info, k - map.dimension);
            for (const char* value : {"-0", "5e-324", "2.2250738585072014e-308", "1e300",
                                      "1.7976931348623157e308", "-1e308", "0.1"}) {
                Scene scene = sceneOf(map);
                if (!set(scene, name + "=" + value).ok()) continue;
                const double kept = numberValue(scene, *numberNamed(scene, name));
                EXPECT_EQ(kept, std::strtod(value, nullptr)) << name;
                EXPECT_EQ(std::signbit(kept), value[0] == '-') << map.info.name << " " << name;
                // What was accepted can be written and read.
                EXPECT_TRUE(sceneFromJson(*parseJson(printJson(sceneToJson(scene)))).ok())
                    << map.info.name << " " << name << "=" << value;
            }
            for (const char* value : {"nan", "inf", "-inf", "1e309", "", "0x10", "1,2,3,4,5"}) {
                Scene scene = sceneOf(map);
                EXPECT_FALSE(set(scene, name + "=" + value).ok())
                    << map.info.name << " " << name << "=" << value;
            }
        }
}

TEST(Document, BareScenesAndWrappedOnes) {
    Scene scene = sceneOf(*findMap("shape-modulus"));
    addAsset(scene, {"g.f3d", {7, 8, 9}});
    Document document;
    document.body = sceneBody(scene);
    document.assets = scene.assets;
    document.render = Json{{"width", 10}};
    EXPECT_FALSE(document.body.contains("assets"));
    EXPECT_EQ(document.assets.size(), 1u);
    const Expected<Document> again =
        documentFromJson(*parseJson(printJson(documentToJson(document))));
    ASSERT_TRUE(again.ok()) << again.status().message();
    EXPECT_EQ(again->kind, DocumentKind::scene);
    EXPECT_EQ(again->body, document.body);
    EXPECT_EQ(assetsToJson(again->assets), assetsToJson(document.assets));
    EXPECT_EQ(again->render, document.render);
    const Expected<Document> bare = documentFromJson(sceneToJson(scene));
    ASSERT_TRUE(bare.ok());
    EXPECT_EQ(bare->body, document.body);
    EXPECT_EQ(assetsToJson(bare->assets), assetsToJson(document.assets));
}

TEST(Document, RefusesOtherThings) {
    const auto fault = [](const std::string& text) {
        const Expected<Document> document =
            documentFromBytes({reinterpret_cast<const unsigned char*>(text.data()), text.size()});
        return document ? std::string() : document.status().message();
    };
    EXPECT_NE(fault(""), "");
    EXPECT_NE(fault("[]"), "");
    EXPECT_NE(fault("hello"), "");
    EXPECT_NE(fault(R"({"document": 2, "kind": "scene", "body": {}})").find("newer"),
              std::string::npos);
    EXPECT_NE(fault(R"({"document": 1, "kind": "film", "body": {}})"), "");
    EXPECT_NE(fault(R"({"document": 1, "kind": "scene"})").find("body"), std::string::npos);
    EXPECT_NE(fault(R"({"document": 1, "body": {}, "extra": 1})").find("extra"), std::string::npos);
    const Expected<std::vector<unsigned char>> png = encodePng(Raster<unsigned char>({2, 2}, 3));
    ASSERT_TRUE(png.ok());
    const Expected<Document> none = documentFromBytes(*png);
    ASSERT_FALSE(none.ok());
    EXPECT_NE(none.status().message().find("carries no scene"), std::string::npos);
}

}  // namespace
}  // namespace versorium
