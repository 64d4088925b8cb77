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

#include "ui/host/worker.h"

// clang-format off
EM_JS(void, worker_js_done,
      (const unsigned char* bytes, int size, const char* head), {
    Module.done(HEAPU8.slice(bytes, bytes + size), UTF8ToString(head));
});
EM_JS(void, worker_js_progress, (double progress), { Module.progress(progress); });
// clang-format on

namespace {

using namespace versorium;

struct Result {
    std::vector<unsigned char> bytes;
    std::string head;  // JSON: at least "message"
};

Worker& worker() {
    static Worker kept;
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
    worker_js_done(result.bytes.data(), static_cast<int>(result.bytes.size()), result.head.c_str());
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

// An asset that the tasks to come name.
EMSCRIPTEN_KEEPALIVE void worker_asset(const char* hash, const char* name,
                                       const unsigned char* bytes, int size) {
    worker().assets.put(hash, std::make_shared<const Asset>(Asset{name, {bytes, bytes + size}}));
}

// Does a request (ui/host/work.h). `threads` counts the one that waits for the others.
EMSCRIPTEN_KEEPALIVE void worker_work(int threads, const char* head, const char* scene) {
    begin(threads, [request = requestFromHead(head, scene)](Job& job) {
        if (!request) return Result{{}, Json{{"message", request.status().message()}}.dump()};
        WorkAnswer answer = compute(worker(), *request, job);
        std::string own = answerHead(answer);
        return Result{std::move(bytesOf(answer.result)), std::move(own)};
    });
}

// Makes a PNG, or a message. Says its progress through Module.progress.
EMSCRIPTEN_KEEPALIVE void worker_export(int threads, const char* document, const char* name) {
    begin(threads, [request =
                        ExportRequest{document, name, false, worker().assets.all()}](Job& job) {
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
        Expected<std::vector<unsigned char>> bytes = computeExport(worker().renderer, request, job);
        const std::string message = bytes ? std::string() : bytes.status().message();
        return Result{bytes ? std::move(*bytes) : std::vector<unsigned char>(),
                      Json{{"message", message}}.dump()};
    });
}

// Gives up the task that runs, which then ends with a message. Only with threads is there anybody
// to hear this.
EMSCRIPTEN_KEEPALIVE void worker_cancel() {
    if (task) task->job.cancel();
}

}  // extern "C"
