// SPDX-License-Identifier: MIT
#pragma once
// What the panels of the studio share. Panels change the workspace and say so by touch(); the
// studio records it for undo once the hand is off.

#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "fields/evaluate.h"
#include "render/bind.h"
#include "render/viewport.h"
#include "ui/host.h"
#include "ui/live_picture.h"
#include "ui/theme.h"
#include "ui/workspace.h"

namespace versorium {

// The places that a view has shown, for back and forward.
struct Visits {
    std::vector<SliceSpec> places;
    std::size_t at = 0;
};

struct ViewState {
    LivePicture picture;
    std::string text, orbits;  // LiveScene's, made anew when the revision is
    std::uint64_t revision = 0;
    double aspect = 0;  // that the text was made for
    Visits visits;
    ImVec2 low{}, high{};  // its rectangle in the window
    enum class Drag { none, pan, marker, box } drag = Drag::none;
    ImVec2 dragFrom{};
};

struct Probe {
    int view = -1;
    double u = 0, v = 0;
    std::string text;
};

// Who draws live pictures: automatic is the graphics processor, unless its driver computes in
// software.
enum class RendererChoice { automatic, graphics, processor };

struct StudioContext {
    explicit StudioContext(Host& host);

    Host& host;
    Workspace workspace;
    History history;
    GpuRenderer gpu;  // before the views, whose pictures are made with it
    RendererChoice renderer = RendererChoice::automatic;
    std::array<ViewState, kMostViews> views;
    std::uint64_t revision = 1;
    bool touched = false;
    double touchedAt = 0;

    std::size_t theme = 0;
    float scale = 1;
    bool fontsChanged = false;
    bool searchOpen = false, keysOpen = false, exportOpen = false, welcome = true;
    int exportWidth = 1600;
    std::string notice;  // the last thing that was done or went wrong
    double noticeAt = -100;
    Probe probe;
    // An animated number: it runs between its ends until it is stopped.
    struct Animation {
        std::string number;
        double low = 0, high = 1, seconds = 8, phase = 0;
        bool running = false;
    } animation;

    // The workspace has changed.
    void touch();
    void say(std::string text);
    void report(const Status& status);
    void undo();
    void redo();
    void open(Workspace opened);
    void newMap(const std::string& name);
    void visit(int view);  // remembers where a view is
    void revisit(int view, int step);
    void home(int view);
    void zoom(int view, double factor, double u, double v);  // the point (u, v) stays where it is
    void pan(int view, double widths, double heights);
    void choose(RendererChoice choice);
    void nextRenderer();
    GpuUse gpuUse();
    void copyLink();
    void saveScene();
    void startExport();

    // Where starting points are measured; null while a shape needs a grid that takes time to make.
    const OrbitProgram* program(int view);
    const OrbitProgram* orbitProgram();

  private:
    struct Bound {
        std::uint64_t revision = 0;
        std::optional<OrbitProgram> program;
    };
    const OrbitProgram* bind(Bound& bound, const Scene& scene);
    Binder binder_;
    std::array<Bound, kMostViews + 1> bound_;
};

// A command with its name, keys and what it does: the list behind Ctrl+K and `?`.
struct Command {
    std::string name, keys;
    std::function<void()> run;
};
std::vector<Command> commandsOf(StudioContext& context);

// Panels. Rectangles are in ImGui's coordinates.
void drawView(StudioContext& context, int view, ImVec2 low, ImVec2 high);
void drawInspector(StudioContext& context);
void drawOrbitStrip(StudioContext& context);
void drawDialogs(StudioContext& context);
void handleKeys(StudioContext& context);

}  // namespace versorium
