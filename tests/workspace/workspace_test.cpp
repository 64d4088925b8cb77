// SPDX-License-Identifier: MIT
#include "workspace/workspace.h"

#include <gtest/gtest.h>

#include "base/base64.h"
#include "colour/srgb.h"
#include "io/document.h"
#include "render/cpu/cpu_renderer.h"

namespace versorium {
namespace {

Workspace mandelbrot() {
    Expected<Scene> scene = presetNamed("mandelbrot");
    EXPECT_TRUE(scene.ok());
    return workspaceOf(*scene);
}

TEST(Workspace, EveryPresetOpensBesideItsPartner) {
    for (const std::string& name : presetNames()) {
        Expected<Scene> scene = presetNamed(name);
        ASSERT_TRUE(scene.ok()) << name;
        const Workspace workspace = workspaceOf(*scene);
        ASSERT_EQ(workspace.views.size(), 2u) << name;
        EXPECT_EQ(sceneToJson(workspace.view()), sceneToJson(*scene)) << name;
        EXPECT_EQ(workspace.views[0].map, workspace.views[1].map) << name;
    }
}

TEST(Workspace, EveryMapHasBothViews) {
    for (const MapKernels& map : catalogue()) {
        const Workspace workspace = workspaceOf(sceneOf(map));
        for (const Scene& scene : workspace.views) {
            const Expected<Scene> again = sceneFromJson(sceneToJson(scene));
            EXPECT_TRUE(again.ok()) << map.info.name << ": " << again.status().message();
        }
        EXPECT_EQ(viewKind(dynamicalView(workspace.views[0])) == ViewKind::parameters,
                  map.dimension == 1)
            << map.info.name;
    }
}

// Dragging the ring of one view changes what the other one draws, and the ring follows.
TEST(Workspace, ViewsAreWelded) {
    Workspace workspace = mandelbrot();
    moveMarker(workspace, 0, -0.125, 0.75);
    for (const Scene& scene : workspace.views)
        EXPECT_EQ(scene.parameters.at("c"), (std::vector<double>{-0.125, 0.75}));
    EXPECT_EQ(markerOf(workspace, 0), (std::array<double, 2>{-0.125, 0.75}));
    moveMarker(workspace, 1, 0.5, -0.25);
    EXPECT_EQ(workspace.point, (std::vector<double>{0.5, -0.25}));
    // The parameter plane still starts at its critical point.
    EXPECT_TRUE(workspace.views[0].criticalStart.has_value());
    EXPECT_EQ(markerOf(workspace, 0), (std::array<double, 2>{-0.125, 0.75}));
}

TEST(Workspace, MarkersFollowWeightedAxesAndOrigins) {
    Workspace workspace = mandelbrot();
    SliceSpec& slice = workspace.views[0].slice;
    slice.axes[0].terms = {{"c.re", 0.5}, {"z.re", 0.25}};
    slice.origin = {{"c.re", 1.0}};
    moveMarker(workspace, 0, 2, 3);
    EXPECT_EQ(sharedNumber(workspace, "c.re"), 2.0);
    EXPECT_EQ(sharedNumber(workspace, "z.re"), 0.5);
    EXPECT_EQ(markerOf(workspace, 0), (std::array<double, 2>{2, 3}));
}

TEST(Workspace, NumbersThatAreNoneAreNotTaken) {
    Workspace workspace = mandelbrot();
    const double before = sharedNumber(workspace, "c.re");
    setSharedNumber(workspace, "c.re", std::numeric_limits<double>::quiet_NaN());
    setSharedNumber(workspace, "nonsense", 1);
    EXPECT_EQ(sharedNumber(workspace, "c.re"), before);
}

TEST(Workspace, ViewCountKeepsTheMarkedView) {
    Workspace workspace = mandelbrot();
    workspace.focused = 1;
    const Json marked = sceneToJson(workspace.view());
    setViewCount(workspace, 1);
    EXPECT_EQ(sceneToJson(workspace.view()), marked);
    setViewCount(workspace, 4);
    EXPECT_EQ(workspace.views.size(), 4u);
    EXPECT_TRUE(workspaceFromJson(workspaceToJson(workspace)).ok());
}

TEST(Links, BringBackEveryPresetAndMap) {
    std::vector<Workspace> all;
    for (const std::string& name : presetNames()) all.push_back(workspaceOf(*presetNamed(name)));
    for (const MapKernels& map : catalogue()) all.push_back(workspaceOf(sceneOf(map)));
    for (const char* text : {"z^3 - a*z + conj(c); a: real = 0.5", "c*sin(z)",
                             "x' = 1 - a*x^2 + y, y' = b*x", "q^2 + c", "r*x*(1 - x)", "z^2 - 1"})
        all.push_back(workspaceOf(*sceneOfMap(text)));
    for (Workspace& workspace : all) {
        workspace.pins.push_back(workspace.views[0].parameters);
        workspace.orbitSteps = 7;
        const Expected<std::string> link = workspaceToLink(workspace);
        ASSERT_TRUE(link.ok()) << link.status().message();
        const Expected<Workspace> again = workspaceFromLink(*link);
        ASSERT_TRUE(again.ok()) << workspace.views[0].map << ": " << again.status().message();
        ASSERT_EQ(again->views.size(), workspace.views.size());
        for (std::size_t k = 0; k < again->views.size(); ++k)
            EXPECT_EQ(sceneToJson(again->views[k]), sceneToJson(workspace.views[k]));
        EXPECT_EQ(again->point, workspace.point);
        EXPECT_EQ(again->pins, workspace.pins);
        EXPECT_EQ(again->orbitSteps, 7);
        EXPECT_EQ(link->find_first_not_of("ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz"
                                          "0123456789-_:"),
                  std::string::npos);
    }
}

// A link is foreign input: whatever is changed in it, it opens or it is refused.
TEST(Links, DamageIsRefusedOrHarmless) {
    const std::string link = *workspaceToLink(mandelbrot());
    std::uint64_t state = 1;
    const auto random = [&] { return state = state * 6364136223846793005u + 1442695040888963407u; };
    for (int round = 0; round < 1000; ++round) {
        std::string damaged = link;
        for (int k = 0; k <= round % 4; ++k)
            damaged[(random() >> 33) % damaged.size()] =
                static_cast<char>(32 + (random() >> 33) % 95);
        if (round % 5 == 0) damaged.resize((random() >> 33) % damaged.size());
        const Expected<Workspace> workspace = workspaceFromLink(damaged);
        EXPECT_TRUE(workspace.ok() || !workspace.status().message().empty());
    }
    for (const char* text : {"", "v1:", "v2:abcd", "v1:????", "v1:AAAA"})
        EXPECT_FALSE(workspaceFromLink(text).ok()) << text;
}

TEST(Links, ScenesThatDoNotBelongTogetherAreRefused) {
    Json json = workspaceToJson(mandelbrot());
    json["views"][1] = sceneToJson(sceneOf(*findMap("newton")));
    EXPECT_FALSE(workspaceFromJson(json).ok());
    json = workspaceToJson(workspaceOf(*sceneOfMap("z^2 + c")));
    json["views"][1] = sceneToJson(*sceneOfMap("c + z^2"));
    EXPECT_FALSE(workspaceFromJson(json).ok());
    json = workspaceToJson(mandelbrot());
    json["unknown"] = 1;
    EXPECT_FALSE(workspaceFromJson(json).ok());
    json = workspaceToJson(mandelbrot());
    json["focused"] = 2;
    EXPECT_FALSE(workspaceFromJson(json).ok());
}

TEST(Links, LargeAssetsNeedAFile) {
    Workspace workspace = mandelbrot();
    std::vector<unsigned char> bytes(kLinkAssetBytes + 1, 1);
    for (Scene& scene : workspace.views) addAsset(scene, {"shape.stl", bytes});
    const Expected<std::string> link = workspaceToLink(workspace);
    ASSERT_FALSE(link.ok());
    EXPECT_EQ(link.status().kind(), ErrorKind::usage);
}

TEST(History, UndoAndRedoBringBackEveryState) {
    Workspace workspace = mandelbrot();
    History history(workspace);
    std::vector<Json> states{workspaceToJson(workspace)};
    for (int k = 1; k <= 50; ++k) {
        setSharedNumber(workspace, "c.re", 0.01 * k);
        history.record(workspace);
        history.record(workspace);  // nothing new
        states.push_back(workspaceToJson(workspace));
    }
    for (int k = 49; k >= 0; --k)
        EXPECT_EQ(workspaceToJson(history.undo()), states[static_cast<std::size_t>(k)]);
    EXPECT_FALSE(history.canUndo());
    for (int k = 1; k <= 50; ++k)
        EXPECT_EQ(workspaceToJson(history.redo()), states[static_cast<std::size_t>(k)]);
    EXPECT_FALSE(history.canRedo());
    // A new deed drops what could have been redone.
    history.undo();
    setSharedNumber(workspace, "c.re", 5);
    history.record(workspace);
    EXPECT_FALSE(history.canRedo());
}

// The pictures of views that are told apart only by numbers along their axes are the same.
TEST(Workspace, APictureDependsOnNothingThatItsSceneLeavesOut) {
    CpuRenderer renderer;
    for (const MapKernels& map : catalogue()) {
        if (map.info.field) continue;  // grids take long; what is left out is the same
        const Workspace workspace = workspaceOf(sceneOf(map));
        for (const Scene& view : workspace.views) {
            Frame frames[2];
            const Scene drawn = pictureScene(view, 1);
            Job job(1);
            ASSERT_TRUE(renderer.render(view, {12, 12}, {}, job, frames[0]).ok()) << map.info.name;
            ASSERT_TRUE(renderer.render(drawn, {12, 12}, {}, job, frames[1]).ok()) << map.info.name;
            EXPECT_EQ(encodeSrgb(frames[0].colour).values(), encodeSrgb(frames[1].colour).values())
                << map.info.name;
        }
    }
    Workspace moved = mandelbrot();
    const std::string before = sceneToJson(pictureScene(moved.views[0], 1)).dump();
    setSharedNumber(moved, "c.re", 0.3);
    EXPECT_EQ(sceneToJson(pictureScene(moved.views[0], 1)).dump(), before);
}

TEST(Workspace, ATallViewShowsAsMuchAcrossAsAWideOneFromBottomToTop) {
    const Scene scene = mandelbrot().views[0];
    EXPECT_EQ(shownHeight(scene, 2), scene.slice.height);
    EXPECT_EQ(shownHeight(scene, 0.5) * 0.5, scene.slice.height);
}

}  // namespace
}  // namespace versorium
