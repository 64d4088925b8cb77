// SPDX-License-Identifier: MIT
#pragma once
// What the panels of the studio share. Panels read the workspace and change it by edit().

#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "i18n/language.h"
#include "render/viewport.h"
#include "ui/host/host.h"
#include "ui/session/bound_programs.h"
#include "ui/session/circles.h"
#include "ui/session/contact_sheet.h"
#include "ui/session/drawing.h"
#include "ui/session/formulas.h"
#include "ui/session/gallery.h"
#include "ui/session/lessons.h"
#include "ui/session/live_picture.h"
#include "ui/session/motion.h"
#include "ui/session/notices.h"
#include "ui/session/open_workspace.h"
#include "ui/session/panel_states.h"
#include "ui/session/player.h"
#include "ui/session/space_view.h"
#include "ui/session/studies.h"
#include "ui/session/teacher.h"
#include "ui/session/versor.h"
#include "ui/session/view_state.h"
#include "ui/widgets/theme.h"
#include "workspace/export_document.h"
#include "workspace/workspace.h"

namespace versorium {

struct Probe {
    int view = -1;
    double u = 0, v = 0;
    std::uint64_t revision = 0;  // of the workspace that it was measured in
    std::string text;            // for the status line
    std::vector<std::pair<std::string, std::string>> rows;  // names and values
};

// What stands over the views. All but the list of keys take the keys while they are open.
struct OpenDialogs {
    bool find = false, keys = false, exporting = false, gallery = false, files = false;
    bool candidates = false, teacher = false;

    bool any() const { return find || exporting || gallery || files || candidates || teacher; }
};

// Who draws live pictures: automatic is the GPU, unless its driver computes in
// software.
enum class RendererChoice { automatic, gpu, cpu };
template <>
struct EnumWords<RendererChoice> {
    static constexpr std::array<std::string_view, 3> table{trLater("automatic"), trLater("GPU"),
                                                           trLater("CPU")};
};

struct StudioContext {
    explicit StudioContext(Host& host);

    Host& host;
    OpenWorkspace edited;
    const Workspace& workspace = edited.now();
    BoundPrograms bound;
    Notices notices;
    Player player;
    GpuDevice gpu;  // before the views, whose pictures are made with it
    RendererChoice renderer = RendererChoice::automatic;
    std::array<ViewState, kMostViews> views;
    bool buttonDown = false;  // of the pointer, wherever it is
    std::size_t theme = 0;
    float scale = 1;
    bool fontsChanged = false;
    OpenDialogs dialogs;
    PanelStates panels;
    bool welcome = true;
    bool imagesAreLayers = false;  // images that are opened lie behind the fractal; else: shapes
    Gallery gallery;
    SavedFormulas formulas;
    FormulaEditor formula;
    ExportOptions exporting;
    bool copying = false;  // the export goes to the clipboard
    Probe probe;
    Studies studies;
    Drawing drawing;
    SpaceView space;
    VersorState versor;
    CircleStudies circles;
    ContactSheet sheet;
    Lessons lessons;
    // The link that the studio was opened with, and the state that its locks hold on to.
    std::optional<TeacherLink> teacher;
    Permitted permitted;

    // Changes the workspace: `change` gets it, and what it returns is returned.
    template <class Change>
    auto edit(Change&& change) {
        return edited.edit(std::forward<Change>(change));
    }
    std::uint64_t revision() const { return edited.revision(); }
    // What was done is a step of the history now.
    void record();
    bool dialogOpen() const { return dialogs.any(); }
    void say(const std::string& text) { notices.say(text); }
    void report(const Status& status) { notices.report(status); }
    void undo();
    void redo();
    void open(Workspace opened);
    // The same of a lesson's step, which the learner does not leave by it.
    void openStage(Workspace stage);
    // The views of the motion's scene, with the motion in the strip below.
    void openMotion(versorium::Animation animation);
    void newMap(const std::string& name);
    void show(PlotPanel plot);  // below the views
    void focus(int view);       // commands act on it
    void remember(int view);    // remembers where a view is
    void goInHistory(int view, int step);
    void home(int view);
    // The point (u, v) stays where it is. Eased, unless motion is to be reduced.
    void zoom(int view, double factor, double u, double v, bool eased = false);
    void glideTo(int view, SliceSpec place);
    void moveTo(int view, SliceSpec place);  // at once
    // Takes all views that are on their way a step further; true while one is.
    bool glide();
    bool gliding() const;
    // Two fingers whose middle went from one place of the window to another while their distance
    // grew by a factor. Whatever a finger had begun to drag is let go. False where no view is.
    bool pinch(ScreenPoint from, ScreenPoint to, double factor);
    void pan(int view, double widths, double heights);
    void chooseTheme(const std::string& name);
    void choose(RendererChoice choice);
    void nextRenderer();
    // From the next frame on in this language.
    void speak(const std::string& id);
    GpuUse gpuUse();
    void stepOrbit(int steps);  // the orbit grows where it ends
    void chooseFile();
    void paste();  // opens what is on the clipboard
    void copyLink();
    void saveScene();
    void startExport();
    void copyImage();
    void takeGrid(const WorkAnswer& answer);
    void takeExport();  // says how an export ended, once it has

    // Width over height of a view in the window.
    double aspect(int view) const;

  private:
    void take(Workspace next);
    void beginExport(const ExportOptions& options, bool toClipboard);
};

}  // namespace versorium
