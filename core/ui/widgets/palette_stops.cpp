// SPDX-License-Identifier: MIT
#include "ui/widgets/palette_stops.h"

#include <algorithm>

namespace versorium {
namespace {

bool rebuild(Palette& palette, std::vector<PaletteStop> stops) {
    Expected<Palette> made =
        Palette::make(kOwnPalette, palette.kind(), palette.space(), std::move(stops));
    if (!made) return false;
    made->interior = palette.interior;
    made->undefined = palette.undefined;
    palette = std::move(*made);
    return true;
}

bool isStop(const Palette& palette, int stop) {
    return stop >= 0 && stop < static_cast<int>(palette.stops().size());
}

}  // namespace

Palette ownPaletteFrom(const Palette& palette) {
    Palette own = palette;
    rebuild(own, palette.stops());
    return own;
}

int addStop(Palette& palette, double position) {
    if (!(position > 0 && position < 1)) return -1;
    std::vector<PaletteStop> stops = palette.stops();
    const auto after = std::find_if(stops.begin(), stops.end(), [&](const PaletteStop& stop) {
        return stop.position > position;
    });
    const int place = static_cast<int>(after - stops.begin());
    stops.insert(after, {position, palette.at(position)});
    return rebuild(palette, std::move(stops)) ? place : -1;
}

void moveStop(Palette& palette, int stop, double position) {
    const int last = static_cast<int>(palette.stops().size()) - 1;
    if (stop <= 0 || stop >= last) return;
    std::vector<PaletteStop> stops = palette.stops();
    const auto at = static_cast<std::size_t>(stop);
    stops[at].position = std::clamp(position, stops[at - 1].position, stops[at + 1].position);
    rebuild(palette, std::move(stops));
}

void colourStop(Palette& palette, int stop, const Colour& colour) {
    if (!isStop(palette, stop)) return;
    std::vector<PaletteStop> stops = palette.stops();
    stops[static_cast<std::size_t>(stop)].colour = colour;
    const bool end = stop == 0 || stop + 1 == static_cast<int>(stops.size());
    if (palette.kind() == PaletteKind::cyclic && end)
        stops.front().colour = stops.back().colour = colour;
    rebuild(palette, std::move(stops));
}

bool deleteStop(Palette& palette, int stop) {
    const int last = static_cast<int>(palette.stops().size()) - 1;
    if (stop <= 0 || stop >= last) return false;
    std::vector<PaletteStop> stops = palette.stops();
    stops.erase(stops.begin() + stop);
    return rebuild(palette, std::move(stops));
}

void turnStops(Palette& palette) {
    std::vector<PaletteStop> stops(palette.stops().rbegin(), palette.stops().rend());
    for (PaletteStop& stop : stops) stop.position = 1 - stop.position;
    rebuild(palette, std::move(stops));
}

}  // namespace versorium
