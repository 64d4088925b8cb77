// SPDX-License-Identifier: MIT
#pragma once
// The picture of one view as it comes: coarse at first, then finer and finer, always the newest
// scene. While a new one is on its way the old one is shown where its points now lie, so that
// nothing jumps.

#include <cstdint>
#include <string>

#include "imgui.h"
#include "ui/host.h"
#include "view/slice.h"

namespace versorium {

class LivePicture {
  public:
    // What should be shown: the scene's JSON, where it lies, and how many samples along each side
    // of a pixel it gets in the end. Asks the host for what is missing.
    void want(Host& host, int view, const std::string& scene, const Viewport& place,
              int finestSamples);
    void take(PictureAnswer answer);
    // Draws what there is into the rectangle.
    void draw(ImDrawList& list, ImVec2 low, ImVec2 high);

    bool waiting() const { return asked_ != 0; }
    bool finished() const { return !waiting() && stage_ == kFinished; }
    // In [0, 1]: how much of the refinement is done.
    float progress() const { return static_cast<float>(stage_) / kFinished; }
    const std::string& message() const { return message_; }
    double seconds() const { return seconds_; }

    void contextLost();

  private:
    static constexpr int kFinished = 3;
    void ask(Host& host, int view);

    std::string wanted_;  // what is asked for
    Viewport place_;
    int finest_ = 2;
    int stage_ = 0;  // coarse, one sample for each pixel, several, finished
    std::uint64_t asked_ = 0;
    int askedDivisor_ = 1;
    int divisor_ = 6;  // of the coarse picture, by how fast the last ones came

    unsigned texture_ = 0;
    Viewport shown_;
    std::vector<unsigned char> pixels_;  // for a context that comes back
    Size pixelSize_{0, 0};
    bool upload_ = false;
    std::string message_;
    double seconds_ = 0;

    void toTexture();
};

}  // namespace versorium
