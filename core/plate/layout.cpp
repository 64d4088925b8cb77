// SPDX-License-Identifier: MIT
// The grid of a plate. Columns share the width of their pictures; what stands beside a picture
// depends on its size (ticks) and takes width from it, so widths are found by a few rounds in which
// margins only grow.
#include <algorithm>
#include <cmath>

#include "plate/caption.h"
#include "plate/panel.h"
#include "plate/plate.h"

namespace versorium {
namespace {

// Narrower pictures, in millimetres, go to fewer columns: in a single column and on a whole page.
constexpr double kLeastNarrow = 20, kLeastWide = 26;
constexpr double kTallest = 1.3;         // of a picture's height to its column's width
constexpr double kTallestPicture = 120;  // millimetres, on a plate of 178
constexpr int kPasses = 3;
constexpr int kRounds = 10;

struct Cell {
    int column = 0, row = 0, span = 1;
};

// Panels in reading order, each at the first place where it fits.
std::vector<Cell> placeCells(const std::vector<PlatePanel>& panels, int columns, int& rows) {
    std::vector<std::vector<bool>> taken;
    std::vector<Cell> cells;
    const auto isFree = [&](int row, int column, int span) {
        if (column + span > columns) return false;
        for (int r = row; r < row + span; ++r)
            for (int c = column; c < column + span; ++c)
                if (r < static_cast<int>(taken.size()) &&
                    taken[static_cast<std::size_t>(r)][static_cast<std::size_t>(c)])
                    return false;
        return true;
    };
    for (const PlatePanel& panel : panels) {
        const int span = std::min(panel.span, columns);
        int place = 0;
        while (!isFree(place / columns, place % columns, span)) ++place;
        const Cell cell{place % columns, place / columns, span};
        while (static_cast<int>(taken.size()) < cell.row + span)
            taken.emplace_back(static_cast<std::size_t>(columns), false);
        for (int r = cell.row; r < cell.row + span; ++r)
            for (int c = cell.column; c < cell.column + span; ++c)
                taken[static_cast<std::size_t>(r)][static_cast<std::size_t>(c)] = true;
        cells.push_back(cell);
    }
    rows = static_cast<int>(taken.size());
    return cells;
}

double sum(const std::vector<double>& values, int first, int last) {
    double total = 0;
    for (int i = first; i < last; ++i) total += values[static_cast<std::size_t>(i)];
    return total;
}

// All sizes in whole pixels. before[i] and after[i] are the margins of column (or row) i.
struct Track {
    std::vector<double> before, after, size, neededBefore, neededAfter;
    double gap = 0;

    explicit Track(int count, double gapBetween)
        : before(static_cast<std::size_t>(count)),
          after(static_cast<std::size_t>(count)),
          size(static_cast<std::size_t>(count)),
          neededBefore(before),
          neededAfter(after),
          gap(gapBetween) {}
    int count() const { return static_cast<int>(size.size()); }
    // From the beginning of picture i to the end of picture i + span - 1.
    double inner(int i, int span) const {
        return sum(size, i, i + span) + sum(before, i + 1, i + span) + sum(after, i, i + span - 1) +
               gap * (span - 1);
    }
    // From the beginning of the track to that of picture i.
    double start(int i) const {
        return sum(size, 0, i) + sum(before, 0, i + 1) + sum(after, 0, i) + gap * i;
    }
    double total() const {
        return sum(size, 0, count()) + sum(before, 0, count()) + sum(after, 0, count()) +
               gap * (count() - 1);
    }
    // Margins back to what the last round needed, all else being as it is.
    void shrink() {
        before = neededBefore;
        after = neededAfter;
    }
    void beginRound() {
        std::fill(neededBefore.begin(), neededBefore.end(), 0.0);
        std::fill(neededAfter.begin(), neededAfter.end(), 0.0);
    }
    // Grows the margins; true when something had to.
    bool need(int i, int span, double beforeIt, double afterIt) {
        double& nb = neededBefore[static_cast<std::size_t>(i)];
        double& na = neededAfter[static_cast<std::size_t>(i + span - 1)];
        nb = std::max(nb, beforeIt);
        na = std::max(na, afterIt);
        double& b = before[static_cast<std::size_t>(i)];
        double& a = after[static_cast<std::size_t>(i + span - 1)];
        const bool grows = beforeIt > b || afterIt > a;
        b = std::max(b, beforeIt);
        a = std::max(a, afterIt);
        return grows;
    }
};

struct Grid {
    Track columns, rows;
    std::vector<Cell> cells;
    std::vector<Size> pictures;
    std::vector<Sheet> sheets;
    double pictureWidth = 0;
};

class GridSolver {
  public:
    GridSolver(const std::vector<PanelContent>& contents, const Metrics& metrics,
               const Theme& theme, double width)
        : contents_(contents), m_(metrics), theme_(theme), width_(width) {}

    Grid solve(const std::vector<Cell>& cells, int columns, int rows) const {
        Grid grid{Track(columns, std::floor(m_.columnGap)),
                  Track(rows, std::floor(m_.rowGap)),
                  cells,
                  {},
                  {},
                  0};
        // The first rounds begin with pictures that are too wide; what they asked for in vain is
        // given back before the last ones.
        for (int pass = 0; pass < kPasses; ++pass) {
            grid.columns.shrink();
            grid.rows.shrink();
            for (int round = 0; round < kRounds; ++round) {
                setWidths(grid);
                setHeights(grid);
                if (!measure(grid)) break;
            }
        }
        return grid;
    }

  private:
    void setWidths(Grid& grid) const {
        std::vector<double>& size = grid.columns.size;
        std::fill(size.begin(), size.end(), 0.0);
        const double room = width_ - grid.columns.total();
        const double each = std::max(8.0, std::floor(room / grid.columns.count()));
        std::fill(size.begin(), size.end(), each);
        grid.pictureWidth = each;
    }

    double tallest(double width) const {
        return std::floor(
            std::min(kTallest * width, kTallestPicture * m_.millimetre * std::max(1.0, enlarge())));
    }
    double enlarge() const { return width_ / (178 * m_.millimetre); }

    void setHeights(Grid& grid) const {
        std::vector<double>& heights = grid.rows.size;
        std::fill(heights.begin(), heights.end(), 0.0);
        for (const bool spanning : {false, true})
            for (std::size_t i = 0; i < contents_.size(); ++i) {
                const Cell& cell = grid.cells[i];
                if ((cell.span > 1) != spanning) continue;
                const double width = grid.columns.inner(cell.column, cell.span);
                const double wanted =
                    std::min(std::floor(width / contents_[i].aspect + 0.5), tallest(width));
                const double missing = wanted - grid.rows.inner(cell.row, cell.span);
                // A large panel may stretch rows that hold nothing else yet, or a little.
                const double share = std::ceil(missing / cell.span);
                for (int r = cell.row; r < cell.row + cell.span && missing > 0; ++r) {
                    double& height = heights[static_cast<std::size_t>(r)];
                    height += height == 0 || !spanning ? share : std::min(share, 0.12 * height);
                }
            }
    }

    // Fits the pictures into their cells and builds the panels; true when a margin grew.
    bool measure(Grid& grid) const {
        grid.pictures.clear();
        grid.sheets.clear();
        bool grew = false;
        grid.columns.beginRound();
        grid.rows.beginRound();
        for (std::size_t i = 0; i < contents_.size(); ++i) {
            const Cell& cell = grid.cells[i];
            const double width = grid.columns.inner(cell.column, cell.span);
            const double height = grid.rows.inner(cell.row, cell.span);
            const double aspect = contents_[i].aspect;
            const double fitted = std::max(8.0, std::min(width, std::floor(height * aspect + 0.5)));
            const Size picture{static_cast<int>(fitted),
                               static_cast<int>(std::max(
                                   8.0, std::min(height, std::floor(fitted / aspect + 0.5))))};
            // A picture narrower than its cell stands in the middle of it, and what is beside it
            // may use the room there.
            const double shift = std::floor(0.5 * (width - picture.width));
            const double margin =
                grid.columns.after[static_cast<std::size_t>(cell.column + cell.span - 1)];
            Sheet sheet = buildPanel(contents_[i], picture, width - shift + margin, m_, theme_);
            const Box& extent = sheet.extent();
            grew |= grid.columns.need(cell.column, cell.span,
                                      std::max(0.0, std::ceil(-extent.left - shift)),
                                      std::max(0.0, std::ceil(extent.right + shift - width)));
            grew |= grid.rows.need(cell.row, cell.span, std::max(0.0, std::ceil(-extent.top)),
                                   std::max(0.0, std::ceil(extent.bottom - height)));
            grid.pictures.push_back(picture);
            grid.sheets.push_back(std::move(sheet));
        }
        return grew;
    }

    const std::vector<PanelContent>& contents_;
    const Metrics& m_;
    const Theme& theme_;
    double width_;
};

int wishedColumns(const Plate& plate) {
    const int count = static_cast<int>(plate.panels.size());
    if (plate.columns > 0) return std::min(plate.columns, 6);
    int cells = 0;
    for (const PlatePanel& panel : plate.panels) cells += panel.span * panel.span;
    return count <= 3 ? count : cells == 4 ? 2 : 3;
}

PanelContent sceneContent(const PlatePanel& panel, const PanelInfo& info) {
    PanelContent content;
    content.aspect = std::clamp(info.aspect, 0.05, 20.0);
    const auto axis = [](const AxisInfo& from, const std::string& label) {
        return PanelAxis{label.empty() ? from.name : label,
                         {ScaleKind::linear, from.low, from.high}};
    };
    if (panel.axes && info.x) content.x = axis(*info.x, panel.xLabel);
    if (panel.axes && info.y) content.y = axis(*info.y, panel.yLabel);
    if (!panel.keys) return content;
    content.bar = info.bar;
    if (content.bar && !panel.barLabel.empty()) content.bar->name = panel.barLabel;
    content.versorKey = info.versorKey;
    for (const LegendEntry& entry : info.legend)
        content.legend.push_back({.colour = entry.colour, .line = {}, .text = entry.text});
    return content;
}

class Composer {
  public:
    Composer(const Plate& plate, const PlateOptions& options, const PanelSource& source,
             const Theme& theme)
        : plate_(plate),
          options_(options),
          source_(source),
          theme_(theme),
          m_(metricsFor(options.widthMillimetres, options.dotsPerInch)) {}

    Expected<PlatePicture> compose() {
        if (Status status = describe(); !status.ok()) return status;
        if (Status status = substitute(); !status.ok()) return status;
        width_ = std::floor(options_.widthMillimetres * m_.millimetre + 0.5);
        margin_ = std::floor(m_.margin);
        const double inner = width_ - 2 * margin_;
        Sheet page;
        double y = margin_;
        if (options_.title)
            y = place(page, "title", title_, Face::serif, m_.title, theme_.text, y, 0.9 * m_.title);
        const Grid grid = chooseGrid(inner);
        const double gridLeft =
            margin_ + std::floor(0.5 * std::max(0.0, inner - grid.columns.total()));
        const double gridTop = y;
        for (std::size_t i = 0; i < plate_.panels.size(); ++i) {
            const Point at = cornerOf(grid, i);
            page.add(grid.sheets[i], gridLeft + at.x, gridTop + at.y, plate_.panels[i].name + "/");
        }
        y = gridTop + grid.rows.total();
        if (options_.caption) {
            y = place(page, "caption", caption_, Face::serif, m_.caption, theme_.text,
                      y + 1.4 * m_.caption, 0);
            y = place(page, "note", note_, Face::mono, m_.note, theme_.secondary,
                      y + (note_.empty() ? 0 : 0.9 * m_.note), 0);
        }
        const double height = std::ceil(std::max(y, page.extent().bottom) + margin_);
        if (width_ * height > kPlatePixelLimit)
            return Status::usage(
                "the plate would have " + std::to_string(static_cast<long long>(width_ * height)) +
                " pixels, more than " + std::to_string(static_cast<long long>(kPlatePixelLimit)) +
                ": choose fewer dots per inch or a smaller width");
        Canvas canvas({static_cast<int>(width_), static_cast<int>(height)}, theme_.background);
        if (Status status = drawScenes(canvas, grid, gridLeft, gridTop); !status.ok())
            return status;
        page.draw(canvas);
        return PlatePicture{canvas.encode(), options_.dotsPerInch, plainText(caption_),
                            alternative(), page.boxes()};
    }

  private:
    Status describe() {
        for (const PlatePanel& panel : plate_.panels) {
            PanelInfo info;
            if (panel.kind == PanelKind::plot) {
                contents_.push_back(plotContent(panel.plot, theme_));
                info.description = describePlot(panel.plot);
            } else {
                Expected<PanelInfo> described = source_.describe(panel.scene);
                if (!described) return described.status().in("panel " + panel.name);
                info = *std::move(described);
                contents_.push_back(sceneContent(panel, info));
            }
            facts_.push_back({panel.name, info.facts});
            descriptions_.push_back(info.description);
        }
        return {};
    }

    static std::string describePlot(const LinePlot& plot) {
        std::string text = "Line plot of " + plot.y.name + " against " + plot.x.name;
        for (std::size_t i = 0; i < plot.lines.size(); ++i)
            if (!plot.lines[i].name.empty()) text += (i == 0 ? ": " : ", ") + plot.lines[i].name;
        return plainText(text) + ".";
    }

    Status substitute() {
        const auto fill = [&](const std::string& text, const std::vector<PanelFacts>& facts,
                              std::string& out) {
            Expected<std::string> filled = substituteFacts(text, facts);
            if (!filled) return filled.status();
            out = *std::move(filled);
            return checkMarkup(out);
        };
        for (const auto& [text, out] : {std::pair{&plate_.title, &title_},
                                        {&plate_.caption, &caption_},
                                        {&plate_.note, &note_}})
            if (Status status = fill(*text, facts_, *out); !status.ok()) return status;
        for (std::size_t i = 0; i < plate_.panels.size(); ++i) {
            std::string title;
            if (Status status = fill(plate_.panels[i].title, {facts_[i]}, title); !status.ok())
                return status.in("panel " + plate_.panels[i].name);
            titles_.push_back(title);
            // A single panel needs no letter.
            if (plate_.panels.size() > 1) contents_[i].letter = "(" + plate_.panels[i].name + ")";
            contents_[i].title = title;
        }
        return {};
    }

    // Puts a text across the plate and returns where the next thing may begin.
    double place(Sheet& page, const std::string& name, const std::string& text, Face face,
                 double size, const Colour& colour, double y, double after) const {
        if (text.empty()) return y;
        const TextBlock block = layoutText(
            text, {.face = face, .size = size, .smallest = m_.smallest, .lineSpacing = 1.36},
            width_ - 2 * margin_);
        y = std::ceil(y);
        page.text(name, block, margin_, y, colour, m_.point);
        return std::ceil(y + std::max(block.height, block.ink.bottom) + after);
    }

    // The widest grid whose pictures are not too small.
    Grid chooseGrid(double inner) const {
        const GridSolver solver(contents_, m_, theme_, inner);
        const double page = std::clamp((options_.widthMillimetres - 89) / 89, 0.0, 1.0);
        const double least = (kLeastNarrow + page * (kLeastWide - kLeastNarrow)) * m_.millimetre;
        for (int columns = wishedColumns(plate_);; --columns) {
            int rows = 0;
            const std::vector<Cell> cells = placeCells(plate_.panels, columns, rows);
            Grid grid = solver.solve(cells, columns, rows);
            if (columns == 1 || grid.pictureWidth >= least) return grid;
        }
    }

    static Point cornerOf(const Grid& grid, std::size_t i) {
        const Cell& cell = grid.cells[i];
        const double spare = grid.columns.inner(cell.column, cell.span) - grid.pictures[i].width;
        return {grid.columns.start(cell.column) + std::floor(0.5 * spare),
                grid.rows.start(cell.row)};
    }

    Status drawScenes(Canvas& canvas, const Grid& grid, double left, double top) const {
        const int all = static_cast<int>(plate_.panels.size());
        for (std::size_t i = 0; i < plate_.panels.size(); ++i) {
            const PlatePanel& panel = plate_.panels[i];
            if (panel.kind == PanelKind::scene) {
                const Expected<Raster<float>> picture =
                    source_.draw(panel.scene, grid.pictures[i], m_.lineWidth);
                if (!picture) return picture.status().in("panel " + panel.name);
                if (picture->size() != grid.pictures[i] || picture->channels() != 4)
                    return Status::usage("panel " + panel.name +
                                         ": the picture has another size than the one asked for");
                const Point at = cornerOf(grid, i);
                canvas.picture(static_cast<int>(left + at.x), static_cast<int>(top + at.y),
                               *picture);
            }
            if (options_.onPanel) options_.onPanel(static_cast<int>(i) + 1, all);
        }
        return {};
    }

    std::string alternative() const {
        const std::size_t count = plate_.panels.size();
        std::string text = title_.empty() ? "" : plainText(title_) + ". ";
        if (count > 1) text += std::to_string(count) + " panels.";
        for (std::size_t i = 0; i < count; ++i) {
            if (count > 1) text += " (" + plate_.panels[i].name + ")";
            if (!titles_[i].empty()) text += " " + plainText(titles_[i]) + ".";
            if (!descriptions_[i].empty()) text += " " + descriptions_[i];
        }
        return text;
    }

    const Plate& plate_;
    const PlateOptions& options_;
    const PanelSource& source_;
    const Theme& theme_;
    Metrics m_;
    double width_ = 0, margin_ = 0;
    std::vector<PanelContent> contents_;
    std::vector<PanelFacts> facts_;
    std::vector<std::string> descriptions_, titles_;
    std::string title_, caption_, note_;
};

}  // namespace

Expected<PlatePicture> layoutPlate(const Plate& plate, const PlateOptions& options,
                                   const PanelSource& source) {
    if (!(options.widthMillimetres >= 60 && options.widthMillimetres <= 2000))
        return Status::usage("the width of a plate is 60 to 2000 mm");
    if (!(options.dotsPerInch >= 50 && options.dotsPerInch <= 2400))
        return Status::usage("the resolution of a plate is 50 to 2400 dots per inch");
    if (plate.panels.empty()) return Status::usage("the plate has no panels");
    const Expected<Theme> theme = themeNamed(options.theme);
    if (!theme) return theme.status();
    return Composer(plate, options, source, *theme).compose();
}

}  // namespace versorium
