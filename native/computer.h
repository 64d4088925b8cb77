// SPDX-License-Identifier: MIT
#pragma once
// Computes beside the window: the newest job of each place on one thread that never stops, and
// exports on another. Both call `wake` when something is there.

#include <array>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <optional>
#include <thread>
#include <vector>

#include "ui/host/worker.h"
#include "workspace/workspace.h"

namespace versorium {

class Computer {
  public:
    explicit Computer(std::function<void()> wake);
    ~Computer();

    void request(WorkRequest request);
    std::optional<WorkAnswer> take();
    void drop(int view);

    // `write` puts the bytes where they belong and says where that is.
    void startExport(ExportRequest request,
                     std::function<Expected<std::string>(std::span<const unsigned char>)> write);
    void cancelExport();
    double exportProgress();
    std::optional<Expected<std::string>> takeExport();

  private:
    void work();
    WorkRequest nextRequest();  // there is one

    std::function<void()> wake_;
    std::mutex mutex_;
    std::condition_variable changed_;
    bool stop_ = false;
    std::array<std::optional<WorkRequest>, kWorkPlaces> waiting_;
    std::optional<WorkJob> computing_;
    std::unique_ptr<Job> job_;
    std::vector<WorkAnswer> answers_;
    Worker worker_;
    std::thread thread_;

    std::unique_ptr<Job> exportJob_;
    bool exporting_ = false;
    std::optional<Expected<std::string>> exported_;
    std::thread exportThread_;
};

}  // namespace versorium
