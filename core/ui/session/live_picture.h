// SPDX-License-Identifier: MIT
#pragma once
// The picture of one view as it comes: coarse at first, then finer and finer, always the newest
// scene. The GPU draws what it can carry, the host's processor everything else.
// While a new picture is on its way the old one is shown where its points now lie, so that nothing
// jumps.

#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>
#include <string>

#include "gpu/gpu_picture.h"
#include "ui/host/host.h"
#include "ui/session/flash_guard.h"
#include "view/slice.h"

namespace versorium {

// A view's scene in all the forms that drawing it takes.
struct LiveScene {
    const Scene& scene;
    const std::string& key;  // equal for equal pictures (scene/parts.h, sceneKey)
    // The same without what changes no orbit: colours, `iso` and the number of members.
    const std::string& orbits;
    const OrbitProgram* program;  // null while its shape has to be made into a grid first
    Viewport place;
    bool moves = false;  // by itself: an animation, a motion that is played, a glide
};

// Who may draw: null where the GPU must not, with the reason.
struct GpuUse {
    GpuDevice* device = nullptr;
    std::string whyNot;
};

class LivePicture {
  public:
    // What should be shown. Asks for what is missing of it.
    void want(Host& host, const GpuUse& gpu, int view, const LiveScene& scene);
    void take(WorkAnswer answer);
    // Lets the GPU draw on for about this long.
    void work(Host& host, double seconds);
    // What is there: a texture, of the place that it was made for, and the place that is wanted.
    // 0 before the first picture.
    unsigned shownTexture();
    const Viewport& shownPlace() const { return shown_; }
    const Viewport& wantedPlace() const { return place_; }

    bool waiting() const { return asked_ != 0 || gpuWorking_; }
    bool finished() const { return !waiting() && stage_ == kFinished; }
    // The GPU has more to do: another frame is due.
    bool working() const { return gpuWorking_; }
    // In [0, 1]: how much of the refinement is done.
    float progress() const;
    const std::string& message() const { return message_; }
    // Whose picture is shown or being made.
    bool onGpu() const { return byGpu_; }
    bool compiling() const;
    // Why the GPU does not draw this; empty where it does.
    const std::string& whyCpu() const { return why_; }

    // Of an averaged map: how many members are counted, of how many; 0 of other pictures. With
    // several samples for each pixel they are counted a second time, which shows when it is done.
    int members() const;
    int memberGoal() const { return goal_; }

    // The newest picture would have been a flash too many (ui/session/flash_guard.h) and waits:
    // another frame is due.
    bool held() const { return held_; }

    // How many pictures were shown so far, coarse ones too.
    int pictures() const { return pictures_; }

    void contextLost();

  private:
    static constexpr int kFinished = 3;
    struct Pace {
        int divisor = 6;  // of the coarse picture, by how fast the last ones came
        void learn(double points, double all, double seconds);
    };

    void ask(Host& host, const GpuUse& gpu, int view, const LiveScene& scene);
    bool askGpu(Host& host, const GpuUse& gpu, const LiveScene& scene, Size size, int samples);
    bool recolour(const GpuUse& gpu, const LiveScene& scene);
    void arrived();
    void takeMembers(const PictureResult& answer, double points, double all);
    bool show();
    bool guarded() const;
    bool admits();
    void hold();

    std::string wanted_;  // the key of what is asked for
    GpuDevice* wantedFrom_ = nullptr;
    Viewport place_;
    int finest_ = 2;
    int stage_ = 0;  // coarse, one sample for each pixel, several, finished
    int askedDivisor_ = 1;
    Pace hostPace_, gpuPace_, memberPace_;
    // Of averaged maps, whose pictures sharpen while the host counts on.
    std::string orbits_;           // of the scene that is wanted
    int goal_ = 0, members_ = 0;   // members in all, and counted at this stage
    int shownMembers_ = 0;         // in the picture that is shown
    int countedStage_ = 0;         // the finest one that was counted for
    int keptStage_ = 0;            // the finest one whose fields the host has kept,
    std::array<int, 5> fields_{};  // namely these
    double portion_ = 0;           // seconds of the next one
    std::string message_;
    int pictures_ = 0;

    std::uint64_t asked_ = 0;            // of the host
    std::vector<unsigned char> pixels_;  // its last answer, for a context that comes back
    Size pixelSize_{0, 0};
    bool upload_ = false;

    std::unique_ptr<GpuPicture> gpu_;
    bool byGpu_ = false, gpuWorking_ = false;
    std::string gpuOrbits_;             // what gpu_ iterates, or has
    int gpuStage_ = 0;                  // that it is for
    std::string refused_, refusedWhy_;  // a scene that failed there while it was drawn
    double gpuSince_ = 0, shownAt_ = 0;
    std::string why_;

    unsigned texture_ = 0;
    Viewport shown_;

    FlashGuard guard_;
    double now_ = 0, movedAt_ = -10;  // when a picture was wanted last, and of something that moves
    bool held_ = false;
};

}  // namespace versorium
