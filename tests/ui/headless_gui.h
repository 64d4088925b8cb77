// SPDX-License-Identifier: MIT
#pragma once
// The studio's panels without a window: ImGui lays out and takes input, nothing is drawn, and no
// picture ever comes.

#include <functional>
#include <map>
#include <optional>
#include <string>

#include "imgui.h"
#include "imgui_internal.h"
#include "ui/backend/software_canvas.h"
#include "ui/session/context.h"
#include "ui/views/view.h"

namespace versorium {

class SilentHost : public Host {
  public:
    double time = 0;
    std::string copied;
    std::string announced;  // the last thing that was
    // There may be no OpenGL where tests run.
    std::map<std::string, std::string> kept{{"renderer", "CPU"}};
    std::vector<ExportRequest> exports;
    std::vector<WorkRequest> requests;
    std::optional<Expected<std::string>> outcome;
    double wakeAfter = -1;
    bool still = false;

    double now() const override { return time; }
    void wake() override {}
    std::string clipboard() override { return copied; }
    void announce(const std::string& text) override { announced = text; }
    void setClipboard(const std::string& text) override { copied = text; }
    void requestWork(WorkRequest request) override { requests.push_back(std::move(request)); }
    std::optional<WorkAnswer> takeAnswer() override { return std::nullopt; }
    // The last one, which is for a view's picture.
    const PictureJob& pictureJob() const { return std::get<PictureJob>(requests.back().job); }
    void startExport(ExportRequest request) override { exports.push_back(request); }
    void cancelExport() override {}
    double exportProgress() const override { return -1; }
    std::optional<Expected<std::string>> takeExport() override {
        return std::exchange(outcome, std::nullopt);
    }
    Expected<std::string> saveFile(const std::string& name,
                                   std::span<const unsigned char>) override {
        return name;
    }
    std::string publicAddress() const override { return ""; }
    void setFragment(const std::string&) override {}
    std::string stored(const std::string& name) override { return kept[name]; }
    void store(const std::string& name, const std::string& text) override { kept[name] = text; }
    bool reducedMotion() const override { return still; }
};

class HeadlessGui {
  public:
    explicit HeadlessGui(ImVec2 size = {1280, 800}) : context_(ImGui::CreateContext()) {
        ImGuiIO& io = ImGui::GetIO();
        io.IniFilename = nullptr;
        io.DisplaySize = size;
        applyTheme(themes()[0], 1);
        ImGui::GetStyle().HoverDelayNormal = ImGui::GetStyle().HoverDelayShort = 0;
        ImGui::GetStyle().HoverStationaryDelay = 0;
        loadFonts(themes()[0], 1);
        io.Fonts->Build();
        canvas_.emplace();
    }
    ~HeadlessGui() {
        canvas_.reset();
        ImGui::DestroyContext(context_);
    }
    HeadlessGui(const HeadlessGui&) = delete;

    // One frame; `panel` is drawn into a window that fills the screen.
    void frame(const std::function<void()>& panel) {
        ImGui::GetIO().DeltaTime = 1.0f / 60;
        ImGui::NewFrame();
        ImGui::SetNextWindowPos({0, 0});
        ImGui::SetNextWindowSize(ImGui::GetIO().DisplaySize);
        ImGui::Begin("panel", nullptr,
                     ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                         ImGuiWindowFlags_NoBringToFrontOnFocus);
        panel();
        bottom = ImGui::GetCursorPosY();
        ImGui::End();
        ImGui::Render();
    }
    bool tooltipShown() const {
        for (ImGuiWindow* window : context_->Windows)
            if ((window->Flags & ImGuiWindowFlags_Tooltip) && window->Active && !window->Hidden)
                return true;
        return false;
    }
    ImGuiID hovered() const { return ImGui::GetHoveredID(); }

    // A window's own cross or scroll bar.
    bool isFrame(ImGuiID id) const {
        for (ImGuiWindow* window : context_->Windows)
            if (id == window->GetID("#CLOSE") ||
                id == ImGui::GetWindowScrollbarID(window, ImGuiAxis_Y))
                return true;
        return false;
    }

    float bottom = 0;  // where the panel's last item ends

  private:
    ImGuiContext* context_;
    std::optional<SoftwareCanvas> canvas_;  // keeps textures where there is no OpenGL
};

}  // namespace versorium
