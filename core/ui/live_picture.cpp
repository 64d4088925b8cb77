// SPDX-License-Identifier: MIT
#include "ui/live_picture.h"

#include <algorithm>
#include <cmath>

#include "ui/texture.h"

namespace versorium {
namespace {

// A coarse picture should take about this long, and no longer than a tenth of a second.
constexpr double kCoarseSeconds = 0.05;
constexpr int kCoarsest = 16;

std::uint64_t nextId() {
    static std::uint64_t last = 0;
    return ++last;
}

}  // namespace

void LivePicture::want(Host& host, int view, const std::string& scene, const Viewport& place,
                       int finestSamples) {
    if (place.size.width < 1 || place.size.height < 1) return;
    const bool same = scene == wanted_ && place.size == place_.size;
    if (same && (waiting() || stage_ == kFinished)) return;
    if (!same) {
        wanted_ = scene;
        place_ = place;
        stage_ = 0;
        message_.clear();
    }
    finest_ = finestSamples;
    ask(host, view);
}

void LivePicture::ask(Host& host, int view) {
    askedDivisor_ = stage_ == 0 ? divisor_ : 1;
    const auto coarse = [&](int length) { return std::max(1, length / askedDivisor_); };
    PictureRequest request;
    request.view = view;
    request.id = asked_ = nextId();
    request.scene = wanted_;
    request.size = {coarse(place_.size.width), coarse(place_.size.height)};
    request.samples = stage_ == 2 ? finest_ : 1;
    host.requestPicture(std::move(request));
}

void LivePicture::take(PictureAnswer answer) {
    if (answer.id != asked_) return;
    asked_ = 0;
    if (!answer.message.empty()) {
        message_ = std::move(answer.message);
        stage_ = kFinished;
        return;
    }
    seconds_ = answer.seconds;
    if (stage_ == 0) {
        // The next coarse picture is made as fine as its time allows.
        const double points = static_cast<double>(answer.size.width) * answer.size.height;
        const double all = static_cast<double>(place_.size.width) * place_.size.height;
        const double rate = points / std::max(answer.seconds, 1e-4);
        divisor_ = std::clamp(static_cast<int>(std::ceil(std::sqrt(all / (rate * kCoarseSeconds)))),
                              1, kCoarsest);
    }
    // What was fine at once needs no second round.
    stage_ = stage_ == 0 && askedDivisor_ == 1 ? 2 : stage_ + 1;
    if (stage_ == 2 && finest_ <= 1) stage_ = kFinished;
    pixels_ = std::move(answer.rgba);
    pixelSize_ = answer.size;
    shown_ = place_;
    upload_ = true;
}

void LivePicture::toTexture() {
    if (!upload_ || pixels_.empty()) return;
    upload_ = false;
    texture_ = putTexture(texture_, pixelSize_, pixels_.data());
}

void LivePicture::draw(ImDrawList& list, ImVec2 low, ImVec2 high) {
    toTexture();
    if (texture_ == 0) return;
    // Where the picture that there is lies in the view that is wanted.
    const double scale = shown_.height / place_.height;
    const double unit = (high.y - low.y) / place_.height;
    const double x = 0.5 * (low.x + high.x) + ((shown_.centre[0] - place_.centre[0]) +
                                               (shown_.centreLow[0] - place_.centreLow[0])) *
                                                  unit;
    const double y = 0.5 * (low.y + high.y) - ((shown_.centre[1] - place_.centre[1]) +
                                               (shown_.centreLow[1] - place_.centreLow[1])) *
                                                  unit;
    const double halfHeight = 0.5 * (high.y - low.y) * scale;
    const double halfWidth = halfHeight * shown_.size.width / shown_.size.height;
    constexpr double kFar = 1e7;
    if (!(std::abs(x) < kFar && std::abs(y) < kFar && halfWidth < kFar)) return;
    const auto corner = [](double u, double v) {
        return ImVec2{static_cast<float>(u), static_cast<float>(v)};
    };
    list.PushClipRect(low, high, true);
    list.AddImage(textureId(texture_), corner(x - halfWidth, y - halfHeight),
                  corner(x + halfWidth, y + halfHeight));
    list.PopClipRect();
}

void LivePicture::contextLost() {
    texture_ = 0;
    upload_ = true;
}

}  // namespace versorium
