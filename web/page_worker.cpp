// SPDX-License-Identifier: MIT
// What the page's workers call: worker.mjs. No OpenGL here, and no studio. One task at a time; what
// it made is given to Module.done().
#include <emscripten/emscripten.h>
#include <emscripten/threading.h>

#include <atomic>
#include <memory>
#include <utility>
#if VERSORIUM_THREADS
#include <thread>
#endif

#include "ui/host/picture_worker.h"

// clang-format off
EM_JS(void, worker_js_done,
      (const unsigned char* bytes, int size, const char* message, double seconds, int members), {
    Module.done(HEAPU8.slice(bytes, bytes + size), UTF8ToString(message), seconds, members);
});
EM_JS(void, worker_js_progress, (double progress), { Module.progress(progress); });
// clang-format on

namespace {

using namespace versorium;

struct Result {
    std::vector<unsigned char> bytes;
    std::string message;
    double seconds = 0;
    int members = 0;
};

PictureMaker& maker() {
    static PictureMaker kept;
    return kept;
}

struct Task {
    explicit Task(int threads) : job(threads) {}
    Job job;
    Result result;
};
// The one that runs.
Task* task = nullptr;

constexpr double kBetweenReports = 100;  // milliseconds

void say(float progress) { worker_js_progress(static_cast<double>(progress)); }

void end() {
    const std::unique_ptr<Task> ended(std::exchange(task, nullptr));
    const Result& result = ended->result;
    worker_js_done(result.bytes.data(), static_cast<int>(result.bytes.size()),
                   result.message.c_str(), result.seconds, result.members);
}

// A thread that waits for others cannot start them in a browser: with threads the task runs on one,
// and the worker's own stays free.
template <class Work>
void begin(int threads, Work work) {
    task = new Task(threads);
#if VERSORIUM_THREADS
    std::thread([work = std::move(work)] {
        task->result = work(task->job);
        emscripten_async_run_in_main_runtime_thread(EM_FUNC_SIG_V, end);
    }).detach();
#else
    task->result = work(task->job);
    end();
#endif
}

}  // namespace

extern "C" {

// Makes RGBA, or a message. `threads` counts the one that waits for the others.
EMSCRIPTEN_KEEPALIVE void worker_picture(int threads, const char* scene, int width, int height,
                                         int samples, double portion, int least) {
    PictureRequest request;
    request.scene = scene;
    request.size = {width, height};
    request.samples = samples;
    request.portion = portion;
    request.least = least;
    begin(threads, [request](Job& job) {
        PictureAnswer answer = computePicture(maker(), request, job);
        return Result{std::move(answer.rgba), std::move(answer.message), answer.seconds,
                      answer.members};
    });
}

// Makes a PNG, or a message. Says its progress through Module.progress.
EMSCRIPTEN_KEEPALIVE void worker_export(int threads, const char* document, const char* name) {
    begin(threads, [request = ExportRequest{document, name, false}](Job& job) {
        std::atomic<double> last = 0;
        job.onProgress = [&](double progress) {
            const double now = emscripten_get_now();
            double before = last;
            if (now - before < kBetweenReports || !last.compare_exchange_strong(before, now))
                return;
#if VERSORIUM_THREADS
            emscripten_async_run_in_main_runtime_thread(EM_FUNC_SIG_VF, say,
                                                        static_cast<float>(progress));
#else
            say(static_cast<float>(progress));
#endif
        };
        Expected<std::vector<unsigned char>> bytes = computeExport(maker().renderer, request, job);
        Result result;
        if (bytes)
            result.bytes = std::move(*bytes);
        else
            result.message = bytes.status().message();
        return result;
    });
}

// Gives up the task that runs, which then ends with a message. Only with threads is there anybody
// to hear this.
EMSCRIPTEN_KEEPALIVE void worker_cancel() {
    if (task) task->job.cancel();
}

}  // extern "C"
