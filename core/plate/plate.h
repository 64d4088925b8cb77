// SPDX-License-Identifier: MIT
#pragma once
// A plate is a figure for print or projection: a grid of lettered panels with axes, colour bars and
// keys, a title, a caption and a last line in small type. A panel shows a scene, which a
// PanelSource draws, a bifurcation diagram of one, or a line plot. The whole layout follows from
// measured text: nothing overlaps and nothing is clipped, at any width and resolution, and no
// letter is smaller than 6 pt.
//
// Texts are markup (plate/markup.h). {name} in a title or caption is replaced by a fact of the
// panels: {alpha} by that of the first panel that has it, {b.alpha} by that of panel b; in a
// panel's own title by its own fact.

#include <array>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "base/json.h"
#include "colour/palette.h"
#include "colour/scale.h"
#include "image/raster.h"
#include "plate/font.h"
#include "scene/scene.h"

namespace versorium {

struct PlotLine {
    std::string name;            // markup, for the legend; may be empty
    std::string style = "line";  // "line", "points" or "both"
    std::vector<double> x, y;    // as many of one as of the other, finite
    friend bool operator==(const PlotLine&, const PlotLine&) = default;
};

struct PlotAxis {
    std::string name;                 // markup
    std::string scale = "linear";     // "linear" or "log"
    std::optional<double> low, high;  // else from the data
    friend bool operator==(const PlotAxis&, const PlotAxis&) = default;
};

struct LinePlot {
    double aspect = 1.5;  // width / height
    PlotAxis x, y;
    std::vector<PlotLine> lines;
    friend bool operator==(const LinePlot&, const LinePlot&) = default;
};

// The attractor of the scene's map against one of its parameters (dynamics/bifurcation_diagram.h).
struct DiagramPlot {
    double aspect = 1.6;      // width / height
    std::string parameter;    // name of a number of the scene: "r", "g.a2"
    double from = 0, to = 1;  // of it, left to right
    int component = 0;        // of the state, bottom to top:
    double low = 0, high = 1;
    int transient = 2000, points = 1000;  // steps before anything is drawn, and drawn
    int across = 3;                       // values of the parameter in each column of pixels
    // Columns where the attractor is a cycle of one of these periods take the colours of lines.
    std::vector<int> periods;
    friend bool operator==(const DiagramPlot&, const DiagramPlot&) = default;
};

// The mean of the distance field of the scene's shape over circles or spheres against their radius,
// with r̂ and the radii where capture and escape are certain (shape/radial_profile.h).
struct ProfilePlot {
    double aspect = 1.5;  // width / height
    double to = 0;        // the largest radius; 0: past the shape
    int radii = 257;      // from 0 to there
    friend bool operator==(const ProfilePlot&, const ProfilePlot&) = default;
};

// A point of a panel in the colour and shape of lines, by order: where the parameters of another
// panel's scene lie on the axes of this one. That panel's heading shows the same sign.
struct PlateMark {
    std::string of;     // name of the panel
    std::string label;  // markup, beside the point; may be empty
    friend bool operator==(const PlateMark&, const PlateMark&) = default;
};

// Curves and points of a panel, in the units of its axes; all of one kind have one look.
struct OverlayPart {
    std::string name;  // for the legend
    bool points = false;
    std::vector<std::vector<std::array<double, 2>>> curves;  // or one list of points
    friend bool operator==(const OverlayPart&, const OverlayPart&) = default;
};

// What is drawn over a plane: curves and points as they are given, such as an orbit; and over a
// dynamical one cycles up to a period, the manifolds of saddles among those up to another one, and
// the critical set (core/dynamics).
struct PlateOverlay {
    std::vector<OverlayPart> parts;
    int cycles = 0, manifolds = 0;  // periods; 0: none
    double length = 20;             // of each branch of a manifold, in heights of the panel
    bool criticalSet = false;

    bool computed() const { return cycles > 0 || manifolds > 0 || criticalSet; }
    bool empty() const { return parts.empty() && !computed(); }
    friend bool operator==(const PlateOverlay&, const PlateOverlay&) = default;
};

enum class PanelKind { scene, plot, diagram, profile };

struct PlatePanel {
    std::string name;   // a letter or a word: how --set and facts reach it; by default a, b, c …
    std::string title;  // markup
    PanelKind kind = PanelKind::scene;
    int span = 1;  // columns and rows that it covers
    bool axes = true;
    bool keys = true;  // colour bar, versor key, legend
    // What replaces the names that the scene gives; empty: the scene's own.
    std::string xLabel, yLabel, barLabel;
    Scene scene;
    LinePlot plot;
    DiagramPlot diagram;           // of the panel's scene
    ProfilePlot profile;           // of the panel's scene
    std::vector<PlateMark> marks;  // on a scene
    PlateOverlay overlay;          // on a scene

    bool hasScene() const { return kind != PanelKind::plot; }
};

struct Plate {
    static constexpr int kVersion = 1;
    static constexpr std::size_t kPanelLimit = 26;
    static constexpr std::size_t kPointLimit = 100000;  // of all lines of one panel
    static constexpr std::size_t kMarkLimit = 6;        // of one panel

    // ISO 639-1, of its texts: keys, names of axes and numbers are written accordingly, in English
    // where the program does not speak it (i18n/language.h).
    std::string language = "en";
    std::string title, caption, note;
    int columns = 0;  // 0: by the number of panels
    std::vector<PlatePanel> panels;
};

// Strict: ErrorKind::data with the path to the fault. Scenes take what they name of `assets`. Every
// default is written out again, so that no picture depends on later defaults.
Expected<Plate> plateFromJson(const Json& value, const Assets& assets = {});
// Without the assets of its scenes.
Json plateToJson(const Plate& plate);

// What a scene says about its picture before it is drawn.
struct AxisInfo {
    std::string name;  // markup, such as "Re c"
    double low = 0, high = 1;
};
struct ColourBar {
    std::string name;  // markup: the quantity
    Scale scale;
    Palette palette;
};
struct LegendEntry {
    Colour colour;
    std::string text;  // markup
};
struct PanelInfo {
    double aspect = 1;             // width / height of the picture, as its axes ask for
    std::optional<AxisInfo> x, y;  // none: a picture in perspective
    std::optional<ColourBar> bar;
    bool versorKey = false;  // red, green, blue are the parts i, j, k from -1 to 1
    std::vector<LegendEntry> legend;
    std::string description;                   // a sentence for the alternative text
    std::map<std::string, std::string> facts;  // markup, for captions: {"alpha": "6"}
};

struct DiagramPicture {
    Raster<float> ink;         // one channel, 0 … 1
    std::vector<int> periods;  // of each column; 0: no cycle, -1: escapes
};

// How scenes become pictures: by the renderer (plate/scene_panels.h), or as a test has it.
struct PanelSource {
    // Says all of the above, ranges of colour bars included.
    std::function<Expected<PanelInfo>(const Scene& scene)> describe;
    // Linear straight-alpha RGBA of exactly this size, row 0 on top. Outlines are to be
    // lineWidth pixels wide.
    std::function<Expected<Raster<float>>(const Scene& scene, Size pixels, double lineWidth)> draw;
    // The same of a bifurcation diagram.
    std::function<Expected<PanelInfo>(const Scene& scene, const DiagramPlot&)> describeDiagram = {};
    std::function<Expected<DiagramPicture>(const Scene& scene, const DiagramPlot&, Size pixels)>
        drawDiagram = {};
    // A line plot of what follows from a scene, and the facts of it.
    std::function<Expected<std::pair<LinePlot, PanelInfo>>(const Scene& scene, const ProfilePlot&)>
        profile = {};
    // Where the parameters of `other` lie on the first two axes of `scene`.
    std::function<Expected<std::array<double, 2>>(const Scene& scene, const Scene& other)> locate =
        {};
    // One part for each kind of curve or point. ErrorKind::usage where the scene is no dynamical
    // plane.
    std::function<Expected<std::vector<OverlayPart>>(const Scene& scene, const PlateOverlay&)>
        overlay = {};
};

struct PlateOptions {
    double widthMillimetres = 178;  // 60 … 2000
    double dotsPerInch = 300;       // 50 … 2400
    std::string theme = "paper";    // or "slide"
    bool title = true;
    bool caption = true;  // caption and note
    // Called with the number of panels drawn so far, and of all.
    std::function<void(int done, int all)> onPanel = {};
};

// Something that takes room: a text or a picture.
struct PlateBox {
    std::string name;      // "title", "b/x tick 3", "b/picture"
    Box box;               // pixels touched
    double pointSize = 0;  // of its smallest letter; 0 for what is not a text
};

struct PlatePicture {
    Raster<unsigned char> pixels;  // sRGB, 3 channels
    double dotsPerInch = 300;
    std::string captionText;      // plain text
    std::string alternativeText;  // plain text
    std::vector<PlateBox> boxes;  // for checks: pairwise disjoint, all within the picture
};

// No more pixels than this in a plate.
inline constexpr double kPlatePixelLimit = 67108864;

// ErrorKind::usage for options and facts that make no sense; what the source reports, with the
// panel's name in front.
Expected<PlatePicture> layoutPlate(const Plate& plate, const PlateOptions& options,
                                   const PanelSource& source);

}  // namespace versorium
