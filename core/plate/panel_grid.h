// SPDX-License-Identifier: MIT
#pragma once
// The grid of a plate. Columns share the width of their pictures; what stands beside a picture
// depends on its size (ticks) and takes width from it, so widths are found in a few rounds in which
// margins only grow. All sizes are whole pixels.

#include <vector>

#include "plate/panel.h"

namespace versorium {

// Where a panel stands: `span` columns and rows.
struct Cell {
    int column = 0, row = 0, span = 1;
};

// Panels in reading order, each at the first place where it fits. Says how many rows there are.
std::vector<Cell> placeCells(const std::vector<PlatePanel>& panels, int columns, int& rows);

// The columns, or the rows: picture i has `size[i]`, and margins before and after it.
struct Track {
    std::vector<double> before, after, size, neededBefore, neededAfter;
    double gap = 0;

    Track(int count, double gapBetween);
    int count() const { return static_cast<int>(size.size()); }
    // From the beginning of picture i to the end of picture i + span - 1.
    double inner(int i, int span) const;
    // From the beginning of the track to that of picture i.
    double start(int i) const;
    double total() const;
    // Margins back to what the last round needed, all else being as it is.
    void shrink();
    void beginRound();
    // Grows the margins; true when something had to.
    bool need(int i, int span, double beforeIt, double afterIt);
};

struct PanelGrid {
    Track columns, rows;
    std::vector<Cell> cells;
    std::vector<Size> pictures;
    std::vector<Sheet> sheets;
    double pictureWidth = 0;  // of a cell that spans one column

    // The upper left corner of a picture. One that is narrower than its cell stands in the middle.
    Point cornerOf(std::size_t i) const;
};

// The panels around pictures as large as the width allows. The contents must outlive the grid.
PanelGrid solveGrid(const std::vector<PanelContent>& contents, const std::vector<Cell>& cells,
                    int columns, int rows, double width, const Metrics& metrics,
                    const Theme& theme);

}  // namespace versorium
