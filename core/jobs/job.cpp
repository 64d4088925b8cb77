// SPDX-License-Identifier: MIT
#include "jobs/job.h"

#include <algorithm>

#if VERSORIUM_THREADS
#include <thread>
#include <vector>
#endif

namespace versorium {

int Job::threads() const {
#if VERSORIUM_THREADS
    if (threads_ > 0) return threads_;
    return std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
#else
    return 1;
#endif
}

void Job::warn(const std::string& text) {
    const std::lock_guard lock(warningMutex_);
    if (std::find(warnings_.begin(), warnings_.end(), text) != warnings_.end()) return;
    warnings_.push_back(text);
    if (onWarning) onWarning(text);
}

std::vector<std::string> Job::warnings() const {
    const std::lock_guard lock(warningMutex_);
    return warnings_;
}

bool Job::parallelFor(std::size_t count, const std::function<void(std::size_t)>& body) {
    done_.store(0, std::memory_order_relaxed);
    total_.store(count, std::memory_order_relaxed);
    std::atomic<std::size_t> next{0};
    const auto work = [&] {
        while (!cancelled()) {
            const std::size_t part = next.fetch_add(1, std::memory_order_relaxed);
            if (part >= count) return;
            body(part);
            done_.fetch_add(1, std::memory_order_relaxed);
            if (onProgress) onProgress(progress());
        }
    };
#if VERSORIUM_THREADS
    const std::size_t helpers =
        std::min(static_cast<std::size_t>(threads()), std::max<std::size_t>(count, 1)) - 1;
    std::vector<std::thread> pool;
    for (std::size_t i = 0; i < helpers; ++i) pool.emplace_back(work);
    work();
    for (std::thread& helper : pool) helper.join();
#else
    work();
#endif
    return !cancelled();
}

}  // namespace versorium
