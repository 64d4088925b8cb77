// SPDX-License-Identifier: MIT
#include "gpu/gpu_picture.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>

#include "fields/ensemble.h"
#include "gpu/gpu_state.h"
#include "math/elementary.h"
#include "render/bind.h"

namespace versorium {
namespace {

// A draw aims at no less than the first, since it has a cost of its own, and at no more than the
// second, so that the screen stays alive and no watchdog wakes.
constexpr double kShortestDraw = 0.004;
constexpr double kLongestDraw = 0.03;
constexpr int kLeastSteps = 16;      // per draw: reading and writing a pixel cost about one
constexpr double kFirstRate = 5e6;   // cautious: a slow processor's, for an expensive map
constexpr double kGrowth = 2;        // of the rate from draw to draw
constexpr double kAboveSlowest = 3;  // rows of escaped orbits are fast, the next may not be
constexpr double kForgetting = 1.02;
// From a draw to its fence where that is seen late: three or four frames pass in a browser whatever
// was drawn. Faster leaves room for more, slower asks for less; in seconds.
constexpr double kFrame = 0.1, kLongestFrame = 0.15;
constexpr double kShrinking = 0.6;

double now() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch())
        .count();
}

}  // namespace

GpuPicture::~GpuPicture() { dropNames(); }

Status GpuPicture::start(const Scene& scene, Size size, const GpuOptions& options) {
    if (needsGrid(scene)) {
        rewind();
        state_ = State::empty;
        return Status::usage(
            "the CPU draws this: its shape has to be made into a distance grid first");
    }
    Binder binder;
    Job job(1);
    Expected<OrbitProgram> program = binder.bind(scene, job);
    if (!program) {
        rewind();
        state_ = State::empty;
        return program.status();
    }
    return start(scene, *program, size, options);
}

Status GpuPicture::start(const Scene& scene, const OrbitProgram& program, Size size,
                         const GpuOptions& options) {
    rewind();
    state_ = State::empty;
    if (Status status = device_.prepare(); !status.ok()) return status;
    if (options.samples < 1 || options.samples > kMostSamples)
        return Status::usage("a picture takes 1 to " + std::to_string(kMostSamples) +
                             " samples along each side of a pixel");
    const GpuLimits& limits = device_.limits();
    if (size.width < 1 || size.height < 1 || size.width > limits.textureSize / options.samples ||
        size.height > limits.textureSize / options.samples)
        return Status::usage("the CPU draws this: the picture does not fit into a texture");
    const Size sampled{size.width * options.samples, size.height * options.samples};
    Expected<GpuOrbits> orbits = GpuOrbits::make(scene, program, sampled, limits);
    if (!orbits) return orbits.status();
    const std::string before = std::move(orbits_.shaderText);
    orbits_ = std::move(*orbits);
    if (before != orbits_.shaderText) {
        // A member runs its whole orbit, and each of its steps goes through a list of roots.
        rate_ = orbits_.counts() ? kFirstRate / std::max(1, orbits_.iterations) : kFirstRate;
        slowest_ = std::numeric_limits<double>::infinity();
    }
    size_ = size;
    options_ = options;
    bound_ = false;
    if (Status status = recolour(scene); !status.ok()) return status;
    state_ = State::iterating;
    return {};
}

Status GpuPicture::recolour(const Scene& scene) {
    if (!orbits_.program.map)
        return Status::usage("there is no picture yet whose colours could change");
    if (scene.colour.outline != SetName::none)
        return Status::usage("the CPU draws this: the outline needs a pixel's neighbours");
    if (scene.colour.contours.size() > kMostGpuContours)
        return Status::usage("the CPU draws this: it has more than " +
                             std::to_string(kMostGpuContours) + " contours");
    if (!scene.layers.empty())
        return Status::usage("the CPU draws this: it lays the images behind and in front");
    OrbitProgram program = orbits_.program;
    program.iso = scene.iso;
    Expected<ColourPass> pass = ColourPass::make(scene, program);
    if (!pass) return pass.status();
    if (Status status = carriesFields(orbits_, pass->fields()); !status.ok()) return status;
    if (orbits_.counts() && scene.ensemble.count != orbits_.members) {
        // More members go on from those that are counted.
        if (scene.ensemble.count < done_ || scene.ensemble.count > kMostGpuMembers)
            return Status::usage("these members have to be counted anew");
        orbits_.members = scene.ensemble.count;
        if (state_ == State::finished && done_ < orbits_.members) state_ = State::iterating;
    }
    scene_ = scene;
    orbits_.program.iso = scene.iso;
    pass_ = std::move(*pass);
    painted_ = coloured_ = false;
    return {};
}

void GpuPicture::rewind() {
    if (fence_ && generation_ == device_.generation()) glDeleteSync(fence_);
    fence_ = nullptr;
    source_ = row_ = done_ = firstMember_ = 0;
    steps_ = 0;
    first_ = true;
    anyOrbits_ = coloured_ = false;
    status_ = {};
}

double GpuPicture::progress() const {
    if (state_ == State::finished) return 1;
    const int height = sampled().height;
    if (units() < 1 || height < 1) return 0;
    return (done_ + static_cast<double>(steps_) * row_ / height) / units();
}

// After a lost context everything is made anew, and the orbits begin again.
bool GpuPicture::recover() {
    if (generation_ == device_.generation() && generation_ >= 0) return true;
    dropNames();
    rewind();
    generation_ = device_.generation();
    bound_ = painted_ = false;
    status_ = device_.prepare();
    return status_.ok();
}

// Whether all that a draw needs is there. False while a program is being compiled, and on failure.
bool GpuPicture::ready(GLuint& program, bool wait) {
    const auto fail = [&](Status status) {
        status_ = std::move(status);
        state_ = State::failed;
        return false;
    };
    if (!recover()) return fail(status_);
    // Both are asked for, so that both compile at once.
    const GpuDevice::Program colours = device_.program(colourText_, wait);
    const GpuDevice::Program orbits = device_.program(orbits_.shaderText, wait);
    if (!colours.status.ok()) return fail(colours.status);
    if (!orbits.status.ok()) return fail(orbits.status);
    if (colours.compiling() || orbits.compiling()) {
        state_ = State::compiling;
        return false;
    }
    program = orbits.name;
    if (Status status = makeTextures(); !status.ok()) return fail(status);
    if (!bound_) {
        uploadLists();
        uploadGrid();
        bound_ = true;
    }
    if (state_ == State::compiling) state_ = State::iterating;
    return true;
}

void GpuPicture::drawUnit(GLuint program, double target) {
    const Size size = sampled();
    const double work = std::max(1.0, rate_ * target);
    if (row_ == 0) {
        int left = std::max(units() - done_, 1);
        if (orbits_.counts()) {
            if (done_ >= firstMember_ + memberWindow()) {
                firstMember_ = done_;
                uploadLists();
            }
            left = std::min(left, firstMember_ + memberWindow() - done_);
        }
        const double fitting = work / (1.0 * size.width * size.height);
        const double least = orbits_.counts() ? 1 : kLeastSteps;
        steps_ = static_cast<int>(
            std::clamp(fitting, std::min<double>(least, left), static_cast<double>(left)));
    }
    const int rows = static_cast<int>(
        std::clamp(work / (1.0 * size.width * steps_), 1.0, 1.0 * (size.height - row_)));

    glUseProgram(program);
    const auto at = [&](const char* name) { return glGetUniformLocation(program, name); };
    glUniform4fv(at("uNumbers"), static_cast<GLsizei>(orbits_.numbers.size() / 4),
                 orbits_.numbers.data());
    glUniform2f(at("uSize"), static_cast<float>(size.width), static_cast<float>(size.height));
    glUniform1i(at("uIterations"), orbits_.iterations);
    if (orbits_.counts()) {
        const Ensemble& ensemble = *orbits_.program.ensemble;
        glUniform1i(at("uMember"), done_ - firstMember_);
        glUniform1i(at("uMembers"), steps_);
        glUniform1i(at("uDrawnList"), ensemble.list);
        glUniform1f(at("uSquaredCapture"), orbits_.squaredCapture);
        glUniform1i(at("uSolid"), ensemble.solid);
        glUniform1f(at("uSquaredSolid"), static_cast<float>(exp(2 * orbits_.program.iso)));
    } else {
        glUniform1i(at("uSteps"), steps_);
    }
    glUniform1i(at("uFirst"), first_);
    glUniform1i(at("uBounded"), orbits_.bounded);
    glUniform1f(at("uSquaredRadius"), orbits_.squaredRadius);
    bindOrbitInputs(program);

    gpu::DrawState state(first_ ? names_.firstFrame : names_.orbitFrames[1 - source_], size);
    state.scissor(0, row_, size.width, rows);
    issued_ = now();
    workIssued_ = 1.0 * rows * size.width * steps_;
    looks_ = 0;
    device_.drawQuad();
    ++device_.iterationDraws;
    fence_ = glFenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0);

    row_ += rows;
    if (row_ < size.height) return;
    row_ = 0;
    done_ = std::min(done_ + steps_, units());
    source_ = 1 - source_;
    first_ = false;
    anyOrbits_ = true;
    coloured_ = false;
    if (done_ >= units()) state_ = State::finished;
}

// Whether the draw that is under way has ended within this time.
bool GpuPicture::awaitUnit(double seconds, double target) {
    if (!fence_) return true;
    ++looks_;
    const auto wanted = static_cast<GLuint64>(std::clamp(seconds, 0.0, 1.0) * 1e9);
    const GLenum result = glClientWaitSync(fence_, GL_SYNC_FLUSH_COMMANDS_BIT,
                                           std::min(wanted, device_.limits().longestWait));
    if (result == GL_TIMEOUT_EXPIRED) return false;
    glDeleteSync(fence_);
    fence_ = nullptr;
    if (result == GL_WAIT_FAILED) {
        status_ = Status::inputOutput("the GPU stopped answering");
        state_ = State::failed;
        return false;
    }
    const double took = std::max(now() - issued_, 1e-5);
    const double measured = workIssued_ / took;
    // A draw that another program held up is forgotten after a while.
    slowest_ *= kForgetting;
    // A fence that was passed before anybody looked only says that the draw took no longer than
    // what lay between. In a browser that is a frame at least, or two: a fence is never waited for.
    if (device_.limits().longestWait == 0 || (result == GL_ALREADY_SIGNALED && looks_ == 1)) {
        if (took > kLongestFrame) slowest_ = std::min(slowest_, measured);
        if (took < kFrame)
            rate_ = std::min(rate_ * kGrowth, slowest_ * kAboveSlowest);
        else if (took > kLongestFrame)
            rate_ *= kShrinking;
        return true;
    }
    // Short draws measure the driver's latency, not the work.
    const bool tells = took > 0.25 * target;
    if (tells) slowest_ = std::min(slowest_, measured);
    const double grown = rate_ * kGrowth;
    rate_ = std::min({tells ? measured : grown, grown, slowest_ * kAboveSlowest});
    return true;
}

Status GpuPicture::finish() {
    if (state_ == State::empty) return Status::usage("there is no picture to finish");
    GLuint program = 0;
    while (state_ == State::iterating || state_ == State::compiling) {
        if (!ready(program, true)) break;
        if (fence_) glDeleteSync(fence_);
        fence_ = nullptr;
        drawUnit(program, kLongestDraw);
        glFinish();
    }
    return status_;
}

bool GpuPicture::advance(double budgetSeconds) {
    if (state_ == State::empty) return true;
    const bool stale = generation_ >= 0 && generation_ != device_.generation();
    if ((state_ == State::finished || state_ == State::failed) && !stale) return true;
    if (stale) state_ = State::iterating;
    const double deadline = now() + budgetSeconds;
    const double target = std::clamp(budgetSeconds, kShortestDraw, kLongestDraw);
    GLuint program = 0;
    if (!ready(program)) return state_ == State::failed;
    do {
        if (!awaitUnit(deadline - now(), target)) return state_ == State::failed;
        drawUnit(program, target);
    } while (state_ == State::iterating && now() < deadline);
    return state_ != State::iterating;
}

}  // namespace versorium
