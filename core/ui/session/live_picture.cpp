// SPDX-License-Identifier: MIT
#include "ui/session/live_picture.h"

#include <algorithm>
#include <cmath>

#include "i18n/language.h"
#include "render/cpu/averaged_map.h"
#include "ui/backend/texture.h"

namespace versorium {
namespace {

// A coarse picture should take about this long, and no longer than a tenth of a second.
constexpr double kCoarseSeconds = 0.05;
constexpr int kCoarsest = 16;
// The coarse picture of an averaged map has about so many members.
constexpr double kFirstMembers = 16;
// Seconds of the first portion of members and of the longest, and how they grow. A page without
// threads gives up what takes 0.4 seconds.
constexpr double kFirstPortion = 0.1, kLongestPortion = 0.25, kPortionGrowth = 1.3;
// Orbits of a picture that are kept on the GPU: 80 bytes each.
constexpr double kMostOrbits = 4.2e6;
// A first picture that takes longer is shown before all its iterations are there, this often.
constexpr double kShowEvery = 0.25;
// After a movement pictures may go on to come.
constexpr double kGuardFor = 1;
// What lies behind colours that are not opaque, in linear light: the ground of a view.
constexpr Colour kGround{0.0030, 0.0033, 0.0048, 1};

std::uint64_t nextId() {
    static std::uint64_t last = 0;
    return ++last;
}

// Which fields are coloured follows from these, of all that colours say.
std::array<int, 5> fieldsOf(const Colouring& colour) {
    return {static_cast<int>(colour.rule), static_cast<int>(colour.field),
            static_cast<int>(colour.interior), static_cast<int>(colour.outline),
            static_cast<int>(colour.smoothing)};
}

void makeTexture(GLuint& name) {
    if (name == 0) glGenTextures(1, &name);
    glBindTexture(GL_TEXTURE_2D, name);
    for (const GLenum filter : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
        glTexParameteri(GL_TEXTURE_2D, filter, GL_LINEAR);
    for (const GLenum wrap : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T})
        glTexParameteri(GL_TEXTURE_2D, wrap, GL_CLAMP_TO_EDGE);
}

}  // namespace

void LivePicture::Pace::learn(double points, double all, double seconds) {
    // The next coarse picture is made as fine as its time allows.
    const double rate = points / std::max(seconds, 1e-4);
    divisor = std::clamp(static_cast<int>(std::ceil(std::sqrt(all / (rate * kCoarseSeconds)))), 1,
                         kCoarsest);
}

void LivePicture::want(Host& host, const GpuUse& gpu, int view, const LiveScene& scene) {
    const Size size = scene.place.size;
    if (size.width < 1 || size.height < 1) return;
    now_ = host.now();
    if (scene.moves) movedAt_ = now_;
    held_ = false;
    const bool same = scene.key == wanted_ && size == place_.size && gpu.device == wantedFrom_;
    if (same && (waiting() || stage_ == kFinished)) return;
    if (!same) {
        const bool sameOrbits = size == place_.size && scene.orbits == orbits_;
        const bool onlyColours = gpu.device && gpu.device == wantedFrom_ && size == place_.size &&
                                 scene.orbits == gpuOrbits_;
        orbits_ = scene.orbits;
        goal_ = showsEnsemble(scene.scene) ? scene.scene.ensemble.count : 0;
        portion_ = kFirstPortion;
        wanted_ = scene.key;
        wantedFrom_ = gpu.device;
        place_ = scene.place;
        finest_ = scene.scene.samples;
        if (asked_ != 0) host.dropPicture(view);
        asked_ = 0;
        message_.clear();
        if (onlyColours && recolour(gpu, scene)) return;
        if (!sameOrbits || goal_ == 0) members_ = shownMembers_ = countedStage_ = 0;
        const std::array<int, 5> fields = fieldsOf(scene.scene.colour);
        if (!sameOrbits || fields != fields_) keptStage_ = 0;
        fields_ = fields;
        // What the host has counted, or measured, it goes on from.
        stage_ = std::max(countedStage_, keptStage_);
        gpuWorking_ = false;
    }
    ask(host, gpu, view, scene);
}

void LivePicture::ask(Host& host, const GpuUse& gpu, int view, const LiveScene& scene) {
    const auto request = [&](const Pace& pace) {
        askedDivisor_ = stage_ == 0 ? pace.divisor : 1;
        return Size{std::max(1, place_.size.width / askedDivisor_),
                    std::max(1, place_.size.height / askedDivisor_)};
    };
    const int samples = stage_ == 2 ? finest_ : 1;
    // An averaged map begins with few members instead of few pixels there.
    byGpu_ = askGpu(host, gpu, scene, request(goal_ > 0 ? Pace{1} : gpuPace_), samples);
    if (byGpu_) return;
    const Size size = request(goal_ > 0 ? memberPace_ : hostPace_);
    asked_ = nextId();
    PictureJob wanted{.view = view, .size = size, .samples = samples};
    if (goal_ > 0) {
        wanted.portion = stage_ == 0 ? kCoarseSeconds : portion_;
        wanted.least = std::min(shownMembers_, goal_);
        portion_ = std::min(kLongestPortion, kPortionGrowth * portion_);
    }
    host.requestWork(requestOf(asked_, scene.scene, wanted));
}

bool LivePicture::askGpu(Host& host, const GpuUse& gpu, const LiveScene& scene, Size size,
                         int samples) {
    gpuOrbits_.clear();
    why_ = gpu.whyNot;
    if (!gpu.device) return false;
    if (wanted_ == refused_) {
        why_ = refusedWhy_;
        return false;
    }
    if (1.0 * size.width * size.height * samples * samples > kMostOrbits) {
        // What it has drawn so far stays; the last refinement is left to the CPU.
        why_ = trLater("so many samples would take too much graphics memory");
        return false;
    }
    if (!scene.program) {
        why_ = trLater("its shape is made into a distance grid there");
        return false;
    }
    if (!gpu_) gpu_ = std::make_unique<GpuPicture>(*gpu.device);
    if (Status status = gpu_->start(scene.scene, *scene.program, size,
                                    {samples, kGround, std::max(1.0, size.height / 400.0)});
        !status.ok()) {
        constexpr std::string_view kPrefix = "the CPU draws this: ";
        why_ = status.message();
        if (why_.starts_with(kPrefix)) why_.erase(0, kPrefix.size());
        return false;
    }
    gpuOrbits_ = scene.orbits;
    gpuStage_ = stage_;
    gpuWorking_ = true;
    gpuSince_ = shownAt_ = host.now();
    return true;
}

bool LivePicture::recolour(const GpuUse&, const LiveScene& scene) {
    if (!gpu_->recolour(scene.scene).ok()) return false;
    byGpu_ = true;
    stage_ = gpuStage_;
    // More members of an ensemble are counted on.
    gpuWorking_ = gpuWorking_ || gpu_->state() == GpuPicture::State::iterating;
    if (gpuWorking_) return true;
    if (gpu_->state() != GpuPicture::State::finished) return false;
    if (!admits()) {
        hold();
        return true;
    }
    if (!show()) return false;
    arrived();
    return true;
}

// The stage that was asked for is there.
void LivePicture::arrived() {
    // What was fine at once needs no second round.
    stage_ = stage_ == 0 && askedDivisor_ == 1 ? 2 : stage_ + 1;
    if (stage_ == 2 && finest_ <= 1) stage_ = kFinished;
}

// A portion more of the members of an averaged map.
void LivePicture::takeMembers(const PictureResult& answer, double points, double all) {
    members_ = answer.members;
    const bool shown = !answer.rgba.empty();
    if (stage_ == 0) {
        memberPace_.learn(points * members_ / kFirstMembers, all, answer.seconds);
        stage_ = 1;
        return;
    }
    countedStage_ = stage_;
    if (shown) shownMembers_ = members_;
    if (members_ < goal_) return;
    arrived();
    portion_ = kFirstPortion;
}

void LivePicture::take(WorkAnswer given) {
    if (given.id != asked_) return;
    asked_ = 0;
    if (!given.message.empty()) {
        message_ = std::move(given.message);
        stage_ = kFinished;
        return;
    }
    PictureResult& answer = std::get<PictureResult>(given.result);
    const double points = 1.0 * answer.size.width * answer.size.height;
    const double all = 1.0 * place_.size.width * place_.size.height;
    if (answer.members > 0) {
        takeMembers(answer, points, all);
        if (answer.rgba.empty()) return;
    } else {
        if (stage_ == 0 && !answer.recoloured) hostPace_.learn(points, all, answer.seconds);
        // A coarse picture that was fine at once is the next stage's.
        if (answer.kept)
            keptStage_ = std::max(keptStage_, stage_ == 0 && askedDivisor_ == 1 ? 1 : stage_);
        arrived();
    }
    if (guarded() && !guard_.admit(lightsOf(answer.rgba, answer.size), now_)) return hold();
    pixels_ = std::move(answer.rgba);
    pixelSize_ = answer.size;
    ++pictures_;
    shown_ = place_;
    upload_ = true;
}

void LivePicture::work(Host& host, double seconds) {
    if (!gpuWorking_) return;
    const bool ended = gpu_->advance(seconds);
    const double now = host.now();
    if (compiling()) gpuSince_ = shownAt_ = now;
    if (!ended) {
        if (stage_ == 0 && now - shownAt_ > kShowEvery && admits() && show()) shownAt_ = now;
        return;
    }
    gpuWorking_ = false;
    if (gpu_->state() == GpuPicture::State::finished && !admits()) return hold();
    if (gpu_->state() != GpuPicture::State::finished || !show()) {
        refused_ = wanted_;  // the next want() asks the host
        refusedWhy_ = gpu_->status().message();
        gpuOrbits_.clear();
        return;
    }
    if (stage_ == 0 && goal_ == 0) {
        const Size made = gpu_->size();
        gpuPace_.learn(1.0 * made.width * made.height, 1.0 * place_.size.width * place_.size.height,
                       now - gpuSince_);
    }
    arrived();
}

// Takes over what the GPU has drawn.
bool LivePicture::show() {
    GLuint name = texture_;
    makeTexture(name);
    texture_ = name;
    if (!gpu_->copyInto(texture_)) return false;
    shown_ = place_;
    ++pictures_;
    pixels_.clear();
    upload_ = false;
    return true;
}

bool LivePicture::guarded() const { return now_ - movedAt_ < kGuardFor; }

// Whether what the GPU has drawn may be shown.
bool LivePicture::admits() {
    if (!guarded() || gpu_->texture() == 0) return true;
    Raster<unsigned char> small;
    const Size size{8 * FlashGuard::kColumns, 8 * FlashGuard::kRows};
    return !gpu_->readSmall(size, small).ok() ||
           guard_.admit(lightsOf(small.values(), small.size()), now_);
}

// The picture that there is stays. The next want() asks anew.
void LivePicture::hold() {
    held_ = true;
    wanted_.clear();
    stage_ = 0;
    shownMembers_ = 0;
}

bool LivePicture::compiling() const {
    return gpuWorking_ && gpu_->state() == GpuPicture::State::compiling;
}

int LivePicture::members() const {
    if (goal_ == 0) return 0;
    if (byGpu_) return stage_ == 0 && gpu_ ? gpu_->members() : goal_;
    return std::max(members_, shownMembers_);
}

float LivePicture::progress() const {
    const bool counts = !gpuWorking_ && goal_ > 0 && stage_ > 0 && stage_ < kFinished;
    const float part = gpuWorking_ ? static_cast<float>(gpu_->progress())
                       : counts    ? static_cast<float>(members_) / static_cast<float>(goal_)
                                   : 0;
    return (static_cast<float>(stage_) + part) / kFinished;
}

unsigned LivePicture::shownTexture() {
    if (upload_ && !pixels_.empty()) {
        upload_ = false;
        texture_ = putTexture(texture_, pixelSize_, pixels_.data());
    }
    return texture_;
}

void LivePicture::contextLost() {
    texture_ = 0;
    upload_ = true;
    // Orbits are iterated anew; what the host drew is still there.
    gpuOrbits_.clear();
    gpuWorking_ = false;
    if (!pixels_.empty()) return;
    wanted_.clear();
    stage_ = 0;
}

}  // namespace versorium
