// SPDX-License-Identifier: MIT
// What the page's workers call: worker.mjs. No OpenGL here, and no studio. A result stays until the
// next call.
#include <emscripten/emscripten.h>
#include <emscripten/threading.h>

#include "ui/picture_worker.h"

// clang-format off
EM_JS(void, worker_js_progress, (double progress), { Module.progress(progress); });
// clang-format on

namespace {

using namespace versorium;

struct Result {
    std::vector<unsigned char> bytes;
    std::string message;
    double seconds = 0;
};

Result& result() {
    static Result kept;
    return kept;
}
CpuRenderer& renderer() {
    static CpuRenderer kept;
    return kept;
}

constexpr double kBetweenReports = 100;  // milliseconds

}  // namespace

extern "C" {

// Leaves RGBA; 0 where there is a message instead.
EMSCRIPTEN_KEEPALIVE int worker_picture(const char* scene, int width, int height, int samples) {
    Job job;
    PictureAnswer answer = computePicture(
        renderer(), {.scene = scene, .size = {width, height}, .samples = samples}, job);
    result() = {std::move(answer.rgba), std::move(answer.message), answer.seconds};
    return result().message.empty() ? 1 : 0;
}

// Leaves a PNG; 0 where there is a message instead. Says its progress through Module.progress.
EMSCRIPTEN_KEEPALIVE int worker_export(const char* document, const char* name) {
    Job job;
    double last = 0;
    // Other threads finish parts as well, but only this one can speak to the page.
    job.onProgress = [&](double progress) {
        if (!emscripten_is_main_runtime_thread()) return;
        const double now = emscripten_get_now();
        if (now - last < kBetweenReports) return;
        last = now;
        worker_js_progress(progress);
    };
    Expected<std::vector<unsigned char>> bytes =
        computeExport(renderer(), {document, name, false}, job);
    result() = {};
    if (bytes)
        result().bytes = std::move(*bytes);
    else
        result().message = bytes.status().message();
    return bytes ? 1 : 0;
}

EMSCRIPTEN_KEEPALIVE const unsigned char* worker_bytes() { return result().bytes.data(); }
EMSCRIPTEN_KEEPALIVE int worker_size() { return static_cast<int>(result().bytes.size()); }
EMSCRIPTEN_KEEPALIVE const char* worker_message() { return result().message.c_str(); }
EMSCRIPTEN_KEEPALIVE double worker_seconds() { return result().seconds; }

}  // extern "C"
