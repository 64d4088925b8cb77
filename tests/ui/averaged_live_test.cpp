// SPDX-License-Identifier: MIT
// Averaged maps as live pictures: they sharpen while members are counted.
#include <gtest/gtest.h>

#include <deque>

#include "render/averaged_star.h"
#include "ui/headless_gui.h"
#include "ui/host/worker.h"

namespace versorium {
namespace {

constexpr Size kSize{60, 44};

std::vector<double> meanByMeasuring(const Scene& scene) {
    CpuRenderer renderer;
    Job job(2);
    std::vector<Raster<double>> rasters;
    EXPECT_TRUE(renderer.measure(scene, kSize, {FieldName::meanMembership}, {}, job, rasters).ok());
    return rasters[0].values();
}

PictureResult answered(Worker& worker, const Scene& scene, Job& job, double portion,
                       int least = 0) {
    const PictureJob wanted{.size = kSize, .samples = 1, .portion = portion, .least = least};
    const WorkAnswer answer = compute(worker, requestOf(1, scene, wanted), job);
    EXPECT_EQ(answer.message, "");
    return std::get<PictureResult>(answer.result);
}

TEST(AveragedPictures, PortionByPortionAreThoseOfOneGo) {
    const Scene scene = averagedStar(24);
    Worker worker;
    Job job(2);
    int members = 0, portions = 0;
    while (members < 24) {
        // No time at all: one member for each request.
        const PictureResult answer = answered(worker, scene, job, 1e-9);
        EXPECT_EQ(answer.members, ++members);
        EXPECT_EQ(answer.rgba.size(), 4u * kSize.width * kSize.height);
        ++portions;
    }
    EXPECT_EQ(portions, 24);
    const auto map = *worker.averaged.of(scene, kSize);
    EXPECT_EQ(map->members(), 24u);
    // What the command line counts.
    EXPECT_EQ(map->mean().values(), meanByMeasuring(scene));
}

TEST(AveragedPictures, OtherColoursCountNothingAndMoreMembersGoOn) {
    Scene scene = averagedStar(20);
    Worker worker;
    Job job(1);
    EXPECT_EQ(answered(worker, scene, job, 100).members, 20);
    const AveragedMap* counted = worker.averaged.of(scene, kSize)->get();
    scene.colour.field = FieldName::standardError;
    scene.colour.palette = "fire";
    scene.colour.contours = {0.01};
    EXPECT_EQ(worker.averaged.of(scene, kSize)->get(), counted);
    EXPECT_EQ(answered(worker, scene, job, 1e-9).members, 20);
    scene.ensemble.count = 30;
    EXPECT_EQ(answered(worker, scene, job, 1e-9).members, 21);
    EXPECT_EQ(answered(worker, scene, job, 100).members, 30);
    EXPECT_EQ((*worker.averaged.of(scene, kSize))->mean().values(), meanByMeasuring(scene));
    // Fewer members are another map, and so is another seed.
    scene.ensemble.count = 10;
    EXPECT_EQ(answered(worker, scene, job, 1e-9).members, 1);
    scene.ensemble.seed = 2;
    EXPECT_EQ((*worker.averaged.of(scene, kSize))->members(), 0u);
}

TEST(AveragedPictures, WithFewerMembersThanShownComeWithoutPixels) {
    const Scene scene = averagedStar(20);
    Worker worker;
    Job job(1);
    PictureResult answer = answered(worker, scene, job, 1e-9, 2);
    EXPECT_EQ(answer.members, 1);
    EXPECT_TRUE(answer.rgba.empty());
    answer = answered(worker, scene, job, 1e-9, 2);
    EXPECT_EQ(answer.members, 2);
    EXPECT_FALSE(answer.rgba.empty());
}

TEST(AveragedPictures, CancelledKeepWhatTheyHad) {
    const Scene scene = averagedStar(20);
    Worker worker;
    Job job(1), cancelled(1);
    EXPECT_EQ(answered(worker, scene, job, 1e-9).members, 1);
    cancelled.cancel();
    const PictureJob wanted{.size = kSize, .samples = 1, .portion = 1};
    EXPECT_NE(compute(worker, requestOf(1, scene, wanted), cancelled).message, "");
    EXPECT_EQ((*worker.averaged.of(scene, kSize))->members(), 1u);
}

// Computes at once, in the place of a worker.
class CountingHost : public SilentHost {
  public:
    Worker worker;
    std::deque<WorkAnswer> answers;

    void requestWork(WorkRequest request) override {
        Job job(1);
        // Shorter than asked for, so that there are several portions.
        std::get<PictureJob>(request.job).portion /= 20;
        answers.push_back(compute(worker, request, job));
        requests.push_back(std::move(request));
    }
};

// A view that shows the scene.
struct View {
    CountingHost host;
    LivePicture picture;

    void want(const Scene& scene) {
        const std::string text = sceneToJson(scene).dump();
        Json json = sceneToJson(scene);
        json.erase("colour");
        json["ensemble"].erase("count");
        const std::string orbits = json.dump();
        picture.want(host, {}, 0, {scene, text, orbits, nullptr, viewportOf(scene, kSize)});
    }
    // Until nothing is missing; the members after each answer.
    std::vector<int> watch(const Scene& scene) {
        std::vector<int> members;
        do {
            want(scene);
            if (host.answers.empty()) break;
            picture.take(std::move(host.answers.front()));
            host.answers.pop_front();
            members.push_back(picture.members());
        } while (!picture.finished());
        return members;
    }
};

TEST(AveragedPictures, ALiveOneSharpensToTheEnd) {
    View view;
    Scene scene = averagedStar(200);
    const std::vector<int> members = view.watch(scene);
    ASSERT_TRUE(view.picture.finished());
    EXPECT_GT(members.size(), 2u);
    EXPECT_LT(members[0], 200);
    EXPECT_EQ(members.back(), 200);
    EXPECT_EQ(view.picture.memberGoal(), 200);
    EXPECT_EQ(view.picture.message(), "");
    EXPECT_LT(std::get<PictureJob>(view.host.requests.front().job).size.width, kSize.width)
        << "the first one is coarse";
    EXPECT_EQ((*view.host.worker.averaged.of(scene, kSize))->mean().values(),
              meanByMeasuring(scene));

    // More members go on from there, and no picture of fewer is shown again.
    scene.ensemble.count = 240;
    for (int counted : view.watch(scene)) EXPECT_GE(counted, 200);
    EXPECT_EQ(view.picture.members(), 240);
}

TEST(AveragedPictures, ALiveOneAsksOnceForOtherColours) {
    View view;
    Scene scene = averagedStar(50);
    view.watch(scene);
    ASSERT_TRUE(view.picture.finished());
    const std::size_t before = view.host.requests.size();
    const int shown = view.picture.pictures();
    scene.colour.palette = "fire";
    EXPECT_EQ(view.watch(scene), std::vector<int>{50});
    EXPECT_EQ(view.host.requests.size(), before + 1);
    EXPECT_EQ(view.host.pictureJob().size, kSize) << "no coarse picture in between";
    EXPECT_EQ(view.picture.pictures(), shown + 1);
}

TEST(AveragedPictures, SeveralSamplesAreCountedBehindThePictureThatIsShown) {
    View view;
    Scene scene = averagedStar(40);
    scene.samples = 2;
    view.watch(scene);
    ASSERT_TRUE(view.picture.finished());
    EXPECT_EQ(view.host.pictureJob().samples, 2);
    EXPECT_EQ(view.host.pictureJob().least, 40);
    EXPECT_EQ((*view.host.worker.averaged.of(scene, kSize))->members(), 40u);
}

}  // namespace
}  // namespace versorium
