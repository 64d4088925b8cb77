// SPDX-License-Identifier: MIT
#pragma once
// What the panels of the studio share. Panels change the workspace and say so by touch(); the
// studio records it for undo once the hand is off.

#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "fields/evaluate.h"
#include "i18n/language.h"
#include "render/bind.h"
#include "render/viewport.h"
#include "ui/controls/access.h"
#include "ui/controls/commands.h"
#include "ui/host/host.h"
#include "ui/session/circles.h"
#include "ui/session/contact_sheet.h"
#include "ui/session/drawing.h"
#include "ui/session/formulas.h"
#include "ui/session/gallery.h"
#include "ui/session/lessons.h"
#include "ui/session/live_picture.h"
#include "ui/session/motion.h"
#include "ui/session/space_view.h"
#include "ui/session/studies.h"
#include "ui/session/versor.h"
#include "ui/session/view_state.h"
#include "ui/widgets/theme.h"
#include "workspace/export_document.h"
#include "workspace/workspace.h"

namespace versorium {

inline constexpr double kNoticeFor = 6;  // seconds that a notice stays

struct Probe {
    int view = -1;
    double u = 0, v = 0;
    std::uint64_t revision = 0;  // of the workspace that it was measured in
    std::string text;            // for the status line
    std::vector<std::pair<std::string, std::string>> rows;  // names and values
};

// The text of a shape as it is typed, and what the scene had when it was last shown.
struct ShapeText {
    std::string text, shown;
};

// The studio's own list of files.
struct FileList {
    Folder folder;
    std::string typed, problem;
    int chosen = 0;
};

// Who draws live pictures: automatic is the graphics processor, unless its driver computes in
// software.
enum class RendererChoice { automatic, graphics, processor };
template <>
struct EnumWords<RendererChoice> {
    static constexpr std::array<std::string_view, 3> table{
        trLater("automatic"), trLater("graphics"), trLater("processor")};
};

struct StudioContext {
    explicit StudioContext(Host& host);

    Host& host;
    Workspace workspace;
    History history;
    GpuDevice gpu;  // before the views, whose pictures are made with it
    RendererChoice renderer = RendererChoice::automatic;
    std::array<ViewState, kMostViews> views;
    std::uint64_t revision = 1;
    bool touched = false;
    bool buttonDown = false;  // of the pointer, wherever it is
    double touchedAt = 0;

    std::size_t theme = 0;
    float scale = 1;
    bool fontsChanged = false;
    bool searchOpen = false, keysOpen = false, exportOpen = false, welcome = true;
    bool galleryOpen = false, fileOpen = false;
    bool imagesAreLayers = false;  // images that are opened lie behind the fractal; else: shapes
    FileList files;
    int galleryAt = 0;  // the entry that the keys have come to: presets first, then recent ones
    Gallery gallery;
    SavedFormulas formulas;
    FormulaEditor formula;
    ExportOptions exporting;
    bool copying = false;  // the export goes to the clipboard
    std::string notice;    // the last thing that was done or went wrong
    double noticeAt = -100;
    Probe probe;
    Studies studies;
    Drawing drawing;
    SpaceView space;
    ShapeText shapeText, alphaShapeText, betaShapeText;
    VersorState versor;
    CircleStudies circles;
    ContactSheet sheet;
    Lessons lessons;
    // The link that the studio was opened with, and the state that its locks hold on to.
    std::optional<TeacherLink> teacher;
    Workspace permitted;
    std::uint64_t permittedAt = 0;
    TeacherDialog handing;
    int paletteStop = -1;  // the chosen stop of an own palette
    int orbitShown = 0;    // the step that the table has been scrolled to
    // An animated number: it runs between its ends until it is stopped, eased to and fro, or
    // steadily from the low end to the high one and again from the low one.
    struct Animation {
        std::string number;
        double low = 0, high = 1;
        double seconds = 8;  // of a round
        double phase = 0;    // in rounds
        bool running = false;
        bool toAndFro = true;
    } animation;

    // The workspace's motion (scene/animation.h) while it is recorded or played.
    struct Player {
        bool recording = false, playing = false;
        bool again = false;  // from the beginning once it has ended
        double at = 0;       // seconds from the motion's beginning
        double since = 0;    // when the recording began
        Recorder recorder;
        int key = -1;  // the chosen key frame
        bool dragsKey = false;
    } player;

    // What the user does with the marked view becomes the motion, from now until it is stopped.
    void record(bool on);
    void play(bool on);
    // Shows the motion at a time.
    void showMotionAt(double time);
    // What is shown now becomes the key frame at the player's time: all that the motion moves, or,
    // where it moves nothing yet, everything.
    void setKey();
    void removeKey();
    void saveMotion();
    bool moves() const { return animation.running || player.playing || player.recording; }

    // Moves a number between two others, from where it is.
    void animate(const std::string& name, double low, double high);
    // Takes the animation on by a part of a round.
    void advanceAnimation(double rounds);

    // The one way to change the workspace: what the change does to it becomes a step of the
    // history once the hand is off. Returns what the change returns.
    template <class Change>
    decltype(auto) edit(Change&& change) {
        const Touch touch{*this};
        return std::forward<Change>(change)(workspace);
    }
    // The workspace has changed.
    void touch();
    // What was done is a step of the history now.
    void record();
    // A dialog stands over the views and takes the keys.
    bool dialogOpen() const {
        return searchOpen || exportOpen || galleryOpen || fileOpen || sheet.open || handing.open;
    }
    // In English or in the language already, where it was put together.
    void say(const std::string& text);
    void report(const Status& status);
    void undo();
    void redo();
    void open(Workspace opened);
    // The same of a lesson's step, which the learner does not leave by it.
    void openStage(Workspace stage);
    // The views of the motion's scene, with the motion in the strip below.
    void openMotion(versorium::Animation animation);
    void newMap(const std::string& name);
    void show(Strip strip);  // below the views
    void mark(int view);     // commands act on it
    void visit(int view);    // remembers where a view is
    void revisit(int view, int step);
    void home(int view);
    // The point (u, v) stays where it is. Eased, unless motion is to be reduced.
    void zoom(int view, double factor, double u, double v, bool eased = false);
    void glideTo(int view, SliceSpec place);
    // Takes all views that are on their way a step further; true while one is.
    bool glide();
    bool gliding() const;
    // Two fingers whose middle went from one place of the window to another while their distance
    // grew by a factor. Whatever a finger had begun to drag is let go. False where no view is.
    bool pinch(ScreenPoint from, ScreenPoint to, double factor);
    void pan(int view, double widths, double heights);
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

    // Width over height of a view in the window.
    double aspect(int view) const;
    // Where starting points are measured; null while a shape needs a grid that takes time to make.
    const OrbitProgram* program(int view);
    const OrbitProgram* orbitProgram();
    Binder& binder() { return binder_; }
    // z_0 … z_orbitSteps of the workspace's point; empty where there is no program.
    const std::vector<std::vector<double>>& orbit();

  private:
    struct Touch {  // when the change is over
        StudioContext& context;
        ~Touch() { context.touch(); }
    };
    void take(Workspace next);
    void beginExport(const ExportOptions& options, bool toClipboard);
    struct Bound {
        std::uint64_t revision = 0;
        std::optional<OrbitProgram> program;
    };
    const OrbitProgram* bind(Bound& bound, const Scene& scene);
    void askForGrid(Scene scene);
    Binder binder_;
    std::uint64_t gridAsked_ = 0;  // the request that is under way
    std::optional<Scene> gridFor_;
    std::string gridRefused_;  // the shape of which no grid can be made
    std::array<Bound, kMostViews + 1> bound_;
    std::uint64_t orbitRevision_ = 0;
    std::vector<std::vector<double>> orbit_;
};

// Panels. Rectangles are in ImGui's coordinates.
void drawPaletteEditor(StudioContext& context);
void drawInspector(StudioContext& context);
void drawLayers(StudioContext& context);
void drawShapePanel(StudioContext& context);
void drawTimeline(StudioContext& context);
void drawOrbitStrip(StudioContext& context);
void drawExport(StudioContext& context);
// Says how an export ended, once it has.
void takeExport(StudioContext& context);
void drawOpenFile(StudioContext& context);
void drawGallery(StudioContext& context);
void drawDialogs(StudioContext& context);

}  // namespace versorium
