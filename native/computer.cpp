// SPDX-License-Identifier: MIT
#include "computer.h"

#include <algorithm>

namespace versorium {
namespace {

bool isThumbnail(const WorkJob& job) { return std::holds_alternative<ThumbnailJob>(job); }

}  // namespace

Computer::Computer(std::function<void()> wake)
    : wake_(std::move(wake)), thread_([this] { work(); }) {}

Computer::~Computer() {
    {
        const std::lock_guard lock(mutex_);
        stop_ = true;
        if (job_) job_->cancel();
        if (exportJob_) exportJob_->cancel();
    }
    changed_.notify_all();
    thread_.join();
    if (exportThread_.joinable()) exportThread_.join();
}

void Computer::request(WorkRequest request) {
    const int place = placeOf(request.job);
    {
        const std::lock_guard lock(mutex_);
        // Whoever looks at a view does not wait for the gallery.
        if (computing_ && (placeOf(*computing_) == place || isThumbnail(*computing_)) && job_)
            job_->cancel();
        waiting_[static_cast<std::size_t>(place)] = std::move(request);
    }
    changed_.notify_all();
}

void Computer::drop(int view) {
    const int place = placeOf(PictureJob{.view = view});
    const std::lock_guard lock(mutex_);
    if (computing_ && placeOf(*computing_) == place && job_) job_->cancel();
    waiting_[static_cast<std::size_t>(place)].reset();
}

std::optional<WorkAnswer> Computer::take() {
    const std::lock_guard lock(mutex_);
    if (answers_.empty()) return std::nullopt;
    WorkAnswer answer = std::move(answers_.front());
    answers_.erase(answers_.begin());
    return answer;
}

// Coarse pictures first: every view shows something before one of them is refined.
WorkRequest Computer::nextRequest() {
    std::optional<WorkRequest>* next = nullptr;
    for (auto& one : waiting_)
        if (one && (!next || isThumbnail((*next)->job) ||
                    (!isThumbnail(one->job) && costOf(one->job) < costOf((*next)->job))))
            next = &one;
    WorkRequest request = std::move(**next);
    next->reset();
    return request;
}

void Computer::work() {
    std::unique_lock lock(mutex_);
    while (true) {
        changed_.wait(lock, [this] {
            return stop_ || std::any_of(waiting_.begin(), waiting_.end(),
                                        [](const auto& one) { return one.has_value(); });
        });
        if (stop_) return;
        WorkRequest request = nextRequest();
        computing_ = request.job;
        job_ = std::make_unique<Job>();
        Job& job = *job_;
        lock.unlock();
        WorkAnswer answer = compute(worker_, request, job);
        lock.lock();
        computing_.reset();
        auto& again = waiting_[static_cast<std::size_t>(placeOf(request.job))];
        if (!job.cancelled())
            answers_.push_back(std::move(answer));
        else if (isThumbnail(request.job) && !again)
            again = std::move(request);
        job_.reset();
        lock.unlock();
        wake_();
        lock.lock();
    }
}

void Computer::startExport(
    ExportRequest request,
    std::function<Expected<std::string>(std::span<const unsigned char>)> write) {
    const std::lock_guard lock(mutex_);
    if (exporting_) return;
    if (exportThread_.joinable()) exportThread_.join();
    exporting_ = true;
    exported_.reset();
    exportJob_ = std::make_unique<Job>();
    exportThread_ = std::thread([this, request = std::move(request), write = std::move(write)] {
        CpuRenderer renderer;
        const Expected<std::vector<unsigned char>> bytes =
            computeExport(renderer, request, *exportJob_);
        Expected<std::string> outcome = bytes ? write(*bytes) : bytes.status();
        {
            const std::lock_guard guard(mutex_);
            exported_ = std::move(outcome);
            exporting_ = false;
        }
        wake_();
    });
}

void Computer::cancelExport() {
    const std::lock_guard lock(mutex_);
    if (exportJob_) exportJob_->cancel();
}

double Computer::exportProgress() {
    const std::lock_guard lock(mutex_);
    return exporting_ ? exportJob_->progress() : -1;
}

std::optional<Expected<std::string>> Computer::takeExport() {
    const std::lock_guard lock(mutex_);
    std::optional<Expected<std::string>> outcome = std::move(exported_);
    exported_.reset();
    return outcome;
}

}  // namespace versorium
