// SPDX-License-Identifier: MIT
#pragma once
// Where the studio's parts stand in the window: views above the plot and beside the inspector, or,
// on a narrow screen, one of them at a time with tabs.

#include "imgui.h"
#include "ui/session/context.h"

namespace versorium {

class WindowLayout {
  public:
    void draw(StudioContext& context, ImVec2 low, ImVec2 size);
    // Whether a view is on the screen.
    bool shows(const Workspace& workspace, std::size_t view) const {
        return !(workspace.maximised || narrow_) || static_cast<int>(view) == workspace.focused;
    }

  private:
    void drawWide(StudioContext& context, ImVec2 low, ImVec2 size);
    void drawNarrow(StudioContext& context, ImVec2 low, ImVec2 size);
    // The rows of tabs; returns where they end.
    float drawTabs(StudioContext& context, ImVec2 low, float wide);
    void drawStatus(StudioContext& context);

    bool narrow_ = false;  // one view at a time
    // What stands below the view on a narrow screen, and whether the plot takes the view's place.
    enum class Sheet { none, controls, lesson } sheet_ = Sheet::none;
    bool plotShown_ = false;
    bool lessonWasOpen_ = false;
};

}  // namespace versorium
