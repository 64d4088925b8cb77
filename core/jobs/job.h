// SPDX-License-Identifier: MIT
#pragma once
// A piece of work that can be cancelled and says how far it is. Parts of it may run on several
// threads and finish in any order; what they compute never depends on the number of threads.

#include <atomic>
#include <cstddef>
#include <functional>
#include <mutex>
#include <string>
#include <vector>

namespace versorium {

class Job {
  public:
    Job() = default;
    explicit Job(int threads) : threads_(threads) {}
    Job(const Job&) = delete;
    Job& operator=(const Job&) = delete;

    // Safe from any thread; the work stops at the next part.
    void cancel() { cancelled_.store(true, std::memory_order_relaxed); }
    bool cancelled() const { return cancelled_.load(std::memory_order_relaxed); }

    // From 0 to 1; never falls while one parallelFor runs.
    double progress() const {
        const std::size_t total = total_.load(std::memory_order_relaxed);
        const double from = from_.load(std::memory_order_relaxed);
        const double done = total == 0
                                ? 0.0
                                : static_cast<double>(done_.load(std::memory_order_relaxed)) /
                                      static_cast<double>(total);
        return from + (to_.load(std::memory_order_relaxed) - from) * done;
    }
    // What runs next is this part of the whole: progress goes from `from` to `to`, both in [0, 1].
    void setPart(double from, double to) {
        done_.store(0, std::memory_order_relaxed);
        from_.store(from, std::memory_order_relaxed);
        to_.store(to, std::memory_order_relaxed);
    }

    // Number of threads to use; 0 means one for each processor.
    int threads() const;

    // Runs body(0) … body(count - 1), each exactly once unless the job is cancelled meanwhile.
    // Returns false when it was cancelled. Serial where the build has no threads.
    bool parallelFor(std::size_t count, const std::function<void(std::size_t)>& body);

    // Called after each part, from whichever thread did it, with progress(). Must be thread-safe.
    std::function<void(double)> onProgress;

    // What whoever reads the result should know, though the work goes on. The same text is kept
    // once. Safe from any thread; texts are in the order in which they came first.
    void warn(const std::string& text);
    std::vector<std::string> warnings() const;
    // Called with each new text, from whichever thread gave it.
    std::function<void(const std::string&)> onWarning;

  private:
    mutable std::mutex warningMutex_;
    std::vector<std::string> warnings_;
    int threads_ = 0;
    std::atomic<bool> cancelled_{false};
    std::atomic<std::size_t> done_{0};
    std::atomic<std::size_t> total_{0};
    std::atomic<double> from_{0}, to_{1};
};

}  // namespace versorium
