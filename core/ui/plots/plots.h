// SPDX-License-Identifier: MIT
#pragma once
// Plots below the views: the orbit as a series or a cobweb diagram, the bifurcation diagram, the
// profile over circles, the motion's time line. They know widgets, the session and marks.

namespace versorium {

struct StudioContext;

// The plot that the workspace shows, with its tabs.
void drawPlot(StudioContext& context);

void drawDiagram(StudioContext& context);
void drawProfile(StudioContext& context);
void drawTimeline(StudioContext& context);

}  // namespace versorium
