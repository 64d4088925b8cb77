// SPDX-License-Identifier: MIT
#include "plate/panel_grid.h"

#include <algorithm>
#include <cmath>

namespace versorium {
namespace {

constexpr double kTallest = 1.3;         // of a picture's height to its column's width
constexpr double kTallestPicture = 120;  // millimetres, on a plate of 178
constexpr int kPasses = 3;
constexpr int kRounds = 24;

double sum(const std::vector<double>& values, int first, int last) {
    double total = 0;
    for (int i = first; i < last; ++i) total += values[static_cast<std::size_t>(i)];
    return total;
}

class GridSolver {
  public:
    GridSolver(const std::vector<PanelContent>& contents, const Metrics& metrics,
               const Theme& theme, double width)
        : contents_(contents), m_(metrics), theme_(theme), width_(width) {}

    PanelGrid solve(const std::vector<Cell>& cells, int columns, int rows) const {
        PanelGrid grid{Track(columns, std::floor(m_.columnGap)),
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
    void setWidths(PanelGrid& grid) const {
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

    void setHeights(PanelGrid& grid) const {
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
    bool measure(PanelGrid& grid) const {
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

}  // namespace

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

Track::Track(int count, double gapBetween)
    : before(static_cast<std::size_t>(count)),
      after(static_cast<std::size_t>(count)),
      size(static_cast<std::size_t>(count)),
      neededBefore(before),
      neededAfter(after),
      gap(gapBetween) {}

double Track::inner(int i, int span) const {
    return sum(size, i, i + span) + sum(before, i + 1, i + span) + sum(after, i, i + span - 1) +
           gap * (span - 1);
}

double Track::start(int i) const {
    return sum(size, 0, i) + sum(before, 0, i + 1) + sum(after, 0, i) + gap * i;
}

double Track::total() const {
    return sum(size, 0, count()) + sum(before, 0, count()) + sum(after, 0, count()) +
           gap * (count() - 1);
}

void Track::shrink() {
    before = neededBefore;
    after = neededAfter;
}

void Track::beginRound() {
    std::fill(neededBefore.begin(), neededBefore.end(), 0.0);
    std::fill(neededAfter.begin(), neededAfter.end(), 0.0);
}

bool Track::need(int i, int span, double beforeIt, double afterIt) {
    const auto first = static_cast<std::size_t>(i), last = static_cast<std::size_t>(i + span - 1);
    neededBefore[first] = std::max(neededBefore[first], beforeIt);
    neededAfter[last] = std::max(neededAfter[last], afterIt);
    const bool grows = beforeIt > before[first] || afterIt > after[last];
    before[first] = std::max(before[first], beforeIt);
    after[last] = std::max(after[last], afterIt);
    return grows;
}

Point PanelGrid::cornerOf(std::size_t i) const {
    const Cell& cell = cells[i];
    const double spare = columns.inner(cell.column, cell.span) - pictures[i].width;
    return {columns.start(cell.column) + std::floor(0.5 * spare), rows.start(cell.row)};
}

PanelGrid solveGrid(const std::vector<PanelContent>& contents, const std::vector<Cell>& cells,
                    int columns, int rows, double width, const Metrics& metrics,
                    const Theme& theme) {
    return GridSolver(contents, metrics, theme, width).solve(cells, columns, rows);
}

}  // namespace versorium
