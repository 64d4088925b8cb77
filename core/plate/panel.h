// SPDX-License-Identifier: MIT
#pragma once
// One panel around its picture: outline, axes, names, colour bar, versor key, legend, heading. The
// upper left corner of the picture is (0, 0) of the sheet; how far the sheet reaches beyond the
// picture is what the grid of the plate must leave free.

#include <optional>
#include <string>
#include <vector>

#include "i18n/language.h"
#include "plate/sheet.h"
#include "plate/theme.h"

namespace versorium {

struct PanelAxis {
    std::string name;  // markup
    Scale scale;       // from left to right, or from bottom to top
};

// How a line of a plot looks.
struct SeriesLook {
    Colour colour;
    std::vector<double> dashes;  // in line widths
    int marker = 0;
};

// A marked point of the picture.
struct PanelMark {
    double x = 0, y = 0;  // shares of the picture's width and height, from its lower left corner
    SeriesLook look;
    std::string label;  // markup
};

// Curves or points over the picture, in shares of its sides from the lower left corner.
struct PanelCurves {
    SeriesLook look;
    bool points = false;
    bool rim = false;  // lines show on any picture
    std::vector<std::vector<Point>> curves;
};

struct LegendRow {
    Colour colour;  // a swatch, unless it is a line of a plot:
    std::optional<SeriesLook> line;
    bool stroke = false, points = false;
    std::string text;  // markup
};

struct PanelContent {
    Words words;         // of the numbers and names along the axes
    std::string letter;  // "(a)", or empty
    std::string title;   // markup
    double aspect = 1;
    std::optional<PanelAxis> x, y;
    std::optional<ColourBar> bar;
    bool versorKey = false;
    std::vector<LegendRow> legend;
    const LinePlot* plot = nullptr;  // drawn by the panel itself
    std::vector<PanelMark> marks;
    std::vector<PanelCurves> overlay;
    std::optional<SeriesLook> sign;  // before the title: the mark that stands for this panel
};

// The heading may reach as far as headingRight, or as far as anything else does. The content must
// outlive the sheet.
Sheet buildPanel(const PanelContent& content, Size picture, double headingRight,
                 const Metrics& metrics, const Theme& theme);

// The content of a line plot: axes from its data, a legend of its lines.
PanelContent plotContent(const LinePlot& plot, const Words& words, const Theme& theme);
SeriesLook seriesLook(const Theme& theme, std::size_t index);
void drawPlot(Canvas& canvas, const LinePlot& plot, const PanelContent& content, const Box& frame,
              const Metrics& metrics, const Theme& theme);
// The marker of a look: filled, of about this radius.
void drawMarker(Canvas& canvas, int marker, Point at, double radius, const Colour& colour,
                const Colour& background);
// A short piece of the line, for the legend.
void drawSample(Canvas& canvas, const LegendRow& row, const Box& box, const Metrics& metrics,
                const Theme& theme);

}  // namespace versorium
