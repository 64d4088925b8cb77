// SPDX-License-Identifier: MIT
#pragma once
// The Host of a page. What JavaScript does for it stands in page/host.mjs: the object that the
// module was created with as "page". Work and exports are computed in workers, which run this very
// program (page_worker.cpp); their answers come back through the functions at the end.

#include <array>
#include <deque>

#include "ui/host/host.h"

namespace versorium {

class PageHost : public Host {
  public:
    double now() const override;
    void wake() override;
    void wakeAfter(double seconds) override;

    std::string clipboard() override { return clipboard_; }
    void setClipboard(const std::string& text) override;

    void requestWork(WorkRequest request) override;
    std::optional<WorkAnswer> takeAnswer() override;

    void startExport(ExportRequest request) override;
    void cancelExport() override;
    bool makesFilms() const override;
    double exportProgress() const override { return progress_; }
    std::optional<Expected<std::string>> takeExport() override;

    Expected<std::string> saveFile(const std::string& name,
                                   std::span<const unsigned char> bytes) override;

    bool chooseFile() override;

    std::string publicAddress() const override;
    void setFragment(const std::string& fragment) override;

    std::string stored(const std::string& name) override;
    void store(const std::string& name, const std::string& text) override;

    bool drawsLessons() const override { return true; }
    std::string preferredLanguage() const override;
    bool toggleFullscreen() override;
    bool reducedMotion() const override;
    void announce(const std::string& text) override;

    // What the page was given by others.
    void pasted(std::string text) { clipboard_ = std::move(text); }
    void answer(WorkAnswer answer) { answers_.push_back(std::move(answer)); }
    // An asset of the newest request of a place, or of the export: a worker has it not. Null where
    // nobody wants it any more.
    const Asset* asset(const std::string& hash) const;
    void exportMoved(double progress) { progress_ = progress; }
    void exportEnded(Expected<std::string> outcome);

  private:
    std::string clipboard_;
    std::deque<WorkAnswer> answers_;
    std::array<Assets, kWorkPlaces + 1> assets_;  // the last ones are the export's
    double progress_ = -1;
    std::optional<Expected<std::string>> exported_;
};

}  // namespace versorium
