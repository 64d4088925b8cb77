// SPDX-License-Identifier: MIT
#pragma once
// One view in one frame of the window: all that marks and the view's own parts are told. A value of
// a few words that is passed on instead of its parts.

#include "imgui.h"
#include "ui/session/context.h"
#include "ui/session/screen.h"
#include "ui/session/view_plane.h"

namespace versorium {

struct ViewFrame {
    StudioContext& context;
    int view;
    ViewPlane plane;
    Pointer pointer;
    ScreenPoint ring;  // where the workspace's point lies

    std::size_t index() const { return static_cast<std::size_t>(view); }
    const Workspace& workspace() const { return context.workspace; }
    // Looked up each time: an edit may put other views in the place of these.
    const Scene& scene() const { return workspace().views[index()]; }
    ViewState& state() const { return context.views[index()]; }
    float scale() const { return context.scale; }
    double u() const { return plane.u(pointer.at.x); }  // of the pointer
    double v() const { return plane.v(pointer.at.y); }
    float away(const ScreenPoint& place) const;  // of the pointer from a place, in pixels
    // Whether the plane of starting points of this map is what the view speaks of: in an analysis
    // only the focused one does.
    bool spoken() const;
    ImDrawList& list() const { return *ImGui::GetWindowDrawList(); }
};

// Of a view of this many pixels in the rectangle that its state has.
ViewFrame frameOf(StudioContext& context, int view, Size size, const Pointer& pointer);

}  // namespace versorium
