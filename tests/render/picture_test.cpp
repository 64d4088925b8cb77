// SPDX-License-Identifier: MIT
#include "render/picture.h"

#include <gtest/gtest.h>

#include "io/image_files.h"

namespace versorium {
namespace {

// What a picture carries gives the same picture, byte for byte.
void expectToRenderItself(const Scene& scene, const PictureOptions& options,
                          const std::string& name) {
    CpuRenderer renderer;
    Job job(1);
    const auto png = renderPicture(renderer, scene, options, job);
    ASSERT_TRUE(png.ok()) << name << ": " << png.status().message();
    const Expected<Document> document = documentFromBytes(*png);
    ASSERT_TRUE(document.ok()) << name << ": " << document.status().message();
    EXPECT_EQ(document->kind, DocumentKind::scene);
    const Expected<Scene> again = sceneWithAssets(document->body, document->assets);
    ASSERT_TRUE(again.ok()) << name << ": " << again.status().message();
    const Expected<PictureOptions> read = pictureOptions(*document);
    ASSERT_TRUE(read.ok()) << name;
    EXPECT_EQ(read->size, pictureSize(scene, options));
    CpuRenderer other;
    Job threads(3);
    const auto copy = renderPicture(other, *again, *read, threads);
    ASSERT_TRUE(copy.ok()) << name;
    EXPECT_TRUE(*copy == *png) << name;
    const auto pixels = readImage(*png);
    ASSERT_TRUE(pixels.ok()) << name;
    EXPECT_EQ(pixels->size(), options.size);
}

TEST(Picture, OfEveryMapCarriesWhatMadeIt) {
    for (const MapKernels& map : catalogue()) {
        Scene scene = sceneOf(map);
        scene.samples = 1;
        scene.iterations = std::min(scene.iterations, 30);
        expectToRenderItself(scene, {.size = {23, 17}}, std::string(map.info.name));
    }
}

TEST(Picture, CarriesAssetsAndOptions) {
    Scene scene = sceneOf(*findMap("shape-modulus"));
    const std::string tetrahedron =
        "v -0.3 -0.3 -0.3\nv 0.4 -0.2 -0.2\nv 0 0.4 -0.2\nv 0 0 0.4\n"
        "f 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";
    scene.shape.source =
        addAsset(scene, {"tetrahedron.obj", {tetrahedron.begin(), tetrahedron.end()}});
    scene.shape.resolution = 12;
    scene.shape.padding = 1;
    scene.colour.outline = SetName::solid;
    expectToRenderItself(scene, {.size = {20, 20}}, "mesh");
    scene.colour.attracted.start.a = 0;
    scene.colour.rule = ColourRule::gradient;
    expectToRenderItself(scene, {.size = {20, 20}, .flavour = Flavour::fast}, "transparent");
}

// A file that could not be written is refused before it is rendered.
TEST(Picture, RefusesWhatNoPngHolds) {
    CpuRenderer renderer;
    Job job(1);
    Scene scene = sceneOf(*findMap("quadratic"));
    scene.samples = 1;
    const auto png = renderPicture(renderer, scene, {.size = {16384, 16384}}, job);
    ASSERT_FALSE(png.ok());
    EXPECT_EQ(png.status().kind(), ErrorKind::usage);
    EXPECT_NE(png.status().message().find("134 megapixels"), std::string::npos)
        << png.status().message();
}

TEST(Picture, HasASizeOfItsOwn) {
    Scene scene = sceneOf(*findMap("quadratic"));
    scene.aspect = 1.5;
    EXPECT_EQ(pictureSize(scene, {}), (Size{1200, 800}));
    EXPECT_EQ(pictureSize(scene, {.size = {5, 7}}), (Size{5, 7}));
    Document document;
    document.render = Json{{"width", 5}, {"height", 70000}};
    EXPECT_FALSE(pictureOptions(document).ok());
    document.render = Json{{"width", 5}, {"flavour", "slow"}};
    EXPECT_FALSE(pictureOptions(document).ok());
}

}  // namespace
}  // namespace versorium
