// SPDX-License-Identifier: MIT
// The channel to whoever computes: jobs of several kinds, and files that travel once.
#include "ui/host/work.h"

#include <gtest/gtest.h>

#include "io/png.h"
#include "scene/parts.h"
#include "ui/headless_gui.h"
#include "ui/host/worker.h"

namespace versorium {
namespace {

// A tetrahedron as the shape, and a sheet of one colour as an image behind.
Scene sceneWithFiles() {
    Scene scene = sceneOf(*findMap("shape-modulus"));
    const std::string mesh =
        "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 "
        "4\nf 1 4 3\nf 2 3 4\n";
    scene.shape.source = addAsset(scene, {"tetra.obj", {mesh.begin(), mesh.end()}});
    scene.shape.resolution = 16;
    scene.shape.padding = 2;
    const auto png = encodePng(Raster<unsigned char>({4, 3}, 3));
    Layer layer;
    layer.sources = {addAsset(scene, {"sheet.png", *png})};
    scene.layers.push_back(layer);
    scene.colour.rule = ColourRule::gradient;
    scene.colour.escaped.start.a = 0.5;
    return scene;
}

WorkRequest afar(const WorkRequest& request) {
    Expected<WorkRequest> there = requestFromHead(requestHead(request), request.scene);
    EXPECT_TRUE(there.ok()) << there.status().message();
    return *there;
}

TEST(Work, EveryKindOfRequestComesThroughAsItWas) {
    const Scene scene = sceneWithFiles();
    for (const WorkJob& job : {WorkJob{PictureJob{3, {40, 30}, 2, 0.25, 7}},
                               WorkJob{ThumbnailJob{{20, 10}, 1, 0.5}}, WorkJob{GridJob{}}}) {
        const WorkRequest request = requestOf(std::uint64_t{1} << 40, scene, job);
        const WorkRequest there = afar(request);
        EXPECT_EQ(there.id, request.id);
        EXPECT_EQ(requestHead(there), requestHead(request));
        EXPECT_EQ(there.job.index(), job.index());
        EXPECT_EQ(placeOf(there.job), placeOf(job));
        // Files come by their names alone.
        ASSERT_EQ(there.assets.size(), 2u);
        for (const auto& [hash, asset] : there.assets) EXPECT_EQ(asset, nullptr);
        EXPECT_EQ(request.scene.find("data"), std::string::npos);
    }
    EXPECT_FALSE(requestFromHead("{\"id\": 1, \"kind\": \"film\"}", "").ok());
    EXPECT_FALSE(requestFromHead("{\"id\": 1, \"kind\": \"picture\", \"view\": 9}", "").ok());
}

TEST(Work, EveryKindOfAnswerComesBackAsItWas) {
    const std::vector<unsigned char> pixels(4u * 5 * 3, 9);
    const WorkResult results[] = {PictureResult{2, {5, 3}, pixels, 0.5, 0, true, true},
                                  ThumbnailResult{{5, 3}, pixels}, GridResult{{1, 2, 3}}};
    for (const WorkResult& result : results) {
        WorkAnswer answer{.id = 8, .result = result};
        std::vector<unsigned char> bytes = bytesOf(answer.result);
        const Expected<WorkAnswer> back = answerFromHead(answerHead(answer), bytes);
        ASSERT_TRUE(back.ok()) << back.status().message();
        EXPECT_EQ(answerHead(*back), answerHead(answer));
        WorkResult there = back->result;
        EXPECT_EQ(bytesOf(there), bytes);
        // Half an answer is none.
        bytes.clear();
        EXPECT_NE(answerFromHead(answerHead(answer), bytes)->message, "");
    }
    // An averaged map has no picture while fewer are counted than are shown.
    const WorkAnswer counted{.result = PictureResult{0, {5, 3}, {}, 0.5, 12}};
    EXPECT_EQ(answerFromHead(answerHead(counted), {})->message, "");
}

TEST(Work, FilesAreAskedForAndThenKept) {
    const Scene scene = sceneWithFiles();
    const PictureJob wanted{.size = {24, 18}, .samples = 1};
    const WorkRequest request = requestOf(5, scene, wanted);
    Worker near, far;
    Job job(1);
    // In the same process the files are shared.
    const WorkAnswer here = compute(near, request, job);
    ASSERT_EQ(here.message, "");
    EXPECT_EQ(near.assets.bytes(), 0u);
    // Elsewhere they are missing first, by name.
    const WorkAnswer none = compute(far, afar(request), job);
    EXPECT_NE(none.message, "");
    EXPECT_EQ(none.id, 5u);
    ASSERT_EQ(none.missing.size(), 2u);
    for (const std::string& hash : none.missing) far.assets.put(hash, scene.assets.at(hash));
    for (int again = 0; again < 2; ++again) {
        const WorkAnswer there = compute(far, afar(request), job);
        ASSERT_EQ(there.message, "");
        EXPECT_TRUE(there.missing.empty());
        EXPECT_EQ(std::get<PictureResult>(there.result).rgba,
                  std::get<PictureResult>(here.result).rgba);
    }
}

// "Recolouring never iterates", and nobody sees that it did not.
TEST(Work, OtherColoursOfAPictureMeasureNothing) {
    Scene scene = *presetNamed("mandelbrot");
    Worker worker;
    Job job(1);
    const auto picture = [&](Worker& where, const Scene& own) {
        const PictureJob wanted{.size = {60, 40}, .samples = 2};
        const WorkAnswer answer = compute(where, requestOf(1, own, wanted), job);
        EXPECT_EQ(answer.message, "");
        return std::get<PictureResult>(answer.result);
    };
    const PictureResult first = picture(worker, scene);
    EXPECT_TRUE(first.kept);
    EXPECT_FALSE(first.recoloured);
    EXPECT_EQ(worker.renderer.measurements(), 1);
    for (const char* palette : {"fire", "dusk", "versorium"}) {
        scene.colour.palette = palette;
        scene.colour.reverse = !scene.colour.reverse;
        const PictureResult other = picture(worker, scene);
        Worker fresh;
        EXPECT_EQ(other.rgba, picture(fresh, scene).rgba) << palette;
        EXPECT_TRUE(other.recoloured);
        EXPECT_NE(other.rgba, first.rgba);
    }
    EXPECT_EQ(worker.renderer.measurements(), 1);
}

// Computes at once, in the place of a worker.
class WorkingHost : public SilentHost {
  public:
    Worker worker;
    std::vector<WorkAnswer> answers;
    void requestWork(WorkRequest request) override {
        Job job(1);
        answers.push_back(compute(worker, request, job));
        requests.push_back(std::move(request));
    }
};

// The studio asks for the fine picture of other colours at once: there is nothing to wait for.
TEST(Work, ALivePictureInOtherColoursIsOneRequest) {
    WorkingHost host;
    LivePicture picture;
    Scene scene = *presetNamed("mandelbrot");
    const auto watch = [&] {
        int asked = 0;
        do {
            Json json = sceneKey(scene);
            const std::string key = json.dump();
            json.erase("colour");
            const std::string orbits = json.dump();
            picture.want(host, {}, 0, {scene, key, orbits, nullptr, viewportOf(scene, {64, 48})});
            if (host.answers.empty()) break;
            picture.take(std::move(host.answers.back()));
            host.answers.clear();
            ++asked;
        } while (!picture.finished());
        return asked;
    };
    EXPECT_GE(watch(), 2);
    const long long measured = host.worker.renderer.measurements();
    scene.colour.palette = "fire";
    EXPECT_EQ(watch(), 1);
    EXPECT_EQ(host.pictureJob().samples, scene.samples);
    EXPECT_EQ(host.worker.renderer.measurements(), measured);
    // Another field is another measurement, which begins coarsely.
    scene.colour.field = FieldName::logModulus;
    EXPECT_GE(watch(), 2);
    EXPECT_GT(host.worker.renderer.measurements(), measured);
}

TEST(AssetStore, LetsGoWhatWasAskedForTheLongestAgo) {
    const auto asset = [](std::size_t size) {
        return std::make_shared<const Asset>(Asset{"x", std::vector<unsigned char>(size)});
    };
    AssetStore store(100);
    store.put("a", asset(40));
    store.put("b", asset(40));
    Assets wanted{{"a", nullptr}};
    EXPECT_TRUE(store.fill(wanted).empty());
    store.put("c", asset(40));
    EXPECT_EQ(store.bytes(), 80u);
    wanted = {{"a", nullptr}, {"b", nullptr}, {"c", nullptr}};
    EXPECT_EQ(store.fill(wanted), std::vector<std::string>{"b"});
    EXPECT_NE(wanted.at("a"), nullptr);
    // One that is too large alone is kept, and alone.
    store.put("d", asset(500));
    EXPECT_EQ(store.bytes(), 500u);
}

TEST(Keys, HoldNoBytesOfFilesAndTellScenesApart) {
    const Scene scene = sceneWithFiles();
    Scene other = scene;
    EXPECT_EQ(sceneKey(scene), sceneKey(other));
    EXPECT_LT(sceneKey(scene).dump().size(), 4000u);
    other.layers[0].sources[0] = other.shape.source;
    EXPECT_NE(sceneKey(scene), sceneKey(other));
    // One that is missing is drawn otherwise.
    other = scene;
    other.assets.erase(other.assets.begin());
    EXPECT_NE(sceneKey(scene), sceneKey(other));
    EXPECT_EQ(sceneBody(scene), sceneBody(other));
    // Undo tells apart what the whole text tells apart.
    Workspace workspace = workspaceOf(scene), moved = workspace;
    EXPECT_EQ(workspaceKey(workspace), workspaceKey(moved));
    moved.views[0].slice.height *= 2;
    EXPECT_NE(workspaceKey(workspace), workspaceKey(moved));
    moved = workspace;
    moved.orbitSteps += 1;
    EXPECT_NE(workspaceKey(workspace), workspaceKey(moved));
}

TEST(Export, TakesItsFilesBesideTheDocument) {
    SilentHost host;
    StudioContext context(host);
    context.open(workspaceOf(sceneWithFiles()));
    context.exporting.width = 32;
    context.startExport();
    ASSERT_EQ(host.exports.size(), 1u) << context.notices.last();
    const ExportRequest& request = host.exports[0];
    EXPECT_EQ(request.document.find("\"data\""), std::string::npos);
    EXPECT_EQ(request.assets.size(), 2u);
    CpuRenderer renderer;
    Job job(1);
    const auto png = computeExport(renderer, request, job);
    ASSERT_TRUE(png.ok()) << png.status().message();
    // The file carries them all the same.
    const Expected<Document> carried = documentFromBytes(*png);
    ASSERT_TRUE(carried.ok());
    EXPECT_EQ(carried->assets.size(), 2u);
}

}  // namespace
}  // namespace versorium
