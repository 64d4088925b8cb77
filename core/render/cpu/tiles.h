// SPDX-License-Identifier: MIT
#pragma once
// Pictures are computed tile by tile; each tile's samples are points of the slice.

#include <algorithm>
#include <vector>

#include "render/viewport.h"
#include "scene/scene.h"

namespace versorium {

inline constexpr int kTile = 32;  // pixels along a side

struct Tile {
    int x, y, width, height;  // in pixels
};
inline std::vector<Tile> tilesOf(Size size) {
    std::vector<Tile> tiles;
    for (int y = 0; y < size.height; y += kTile)
        for (int x = 0; x < size.width; x += kTile)
            tiles.push_back(
                {x, y, std::min(kTile, size.width - x), std::min(kTile, size.height - y)});
    return tiles;
}

// Coordinates of the samples of a tile, row after row.
struct Samples {
    std::vector<double> u, v, w;
    void add(double x, double y) {
        u.push_back(x);
        v.push_back(y);
        w.push_back(0);
    }
};

inline double thirdCoordinate(const Scene& scene) {
    return scene.slice.centre.size() > 2 ? scene.slice.centre[2] + scene.slice.centreLow[2] : 0;
}

// `view` is that of the picture with perSide samples along each side of a pixel.
inline Samples samplesOf(const Tile& tile, int perSide, const Viewport& view, double third) {
    Samples samples;
    for (int y = tile.y * perSide; y < (tile.y + tile.height) * perSide; ++y)
        for (int x = tile.x * perSide; x < (tile.x + tile.width) * perSide; ++x)
            samples.add(view.u(x), view.v(y));
    std::fill(samples.w.begin(), samples.w.end(), third);
    return samples;
}

}  // namespace versorium
