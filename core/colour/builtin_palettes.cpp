// SPDX-License-Identifier: MIT
// The built-in palettes: tables where the numbers are published or designed by hand, formulas in
// OKLCh where a palette has a law. One list; everything else walks it.
#include <cassert>
#include <cstdint>

#include "colour/palette.h"
#include "math/elementary.h"

namespace versorium {
namespace {

constexpr double kDegree = 0.017453292519943295;

Palette checked(Expected<Palette> palette) {
    assert(palette.ok());
    return *std::move(palette);
}

Palette table(const char* name, PaletteKind kind, std::initializer_list<std::uint32_t> colours) {
    std::vector<PaletteStop> stops;
    for (const std::uint32_t rgb : colours)
        stops.push_back(
            {static_cast<double>(stops.size()) / static_cast<double>(colours.size() - 1),
             colourFromRgb(rgb)});
    return checked(Palette::make(name, kind, PaletteSpace::oklab, std::move(stops)));
}

// Stops of a law from [0, 1] to OKLCh; an even number of steps, so that the middle is a stop.
template <class Law>
Palette law(const char* name, PaletteKind kind, int steps, Law colourAt) {
    std::vector<PaletteStop> stops;
    for (int k = 0; k <= steps; ++k) {
        const double t = static_cast<double>(k) / steps;
        stops.push_back({t, clipped(colourFromOklab(oklabFromOklch(colourAt(t))))});
    }
    if (kind == PaletteKind::cyclic) stops.back().colour = stops.front().colour;
    return checked(Palette::make(name, kind, PaletteSpace::oklab, std::move(stops)));
}

// Two arms of equal lightness and chroma that differ in hue, from white outwards.
Palette twoArms(const char* name, double lowHue, double highHue, double chroma) {
    return law(name, PaletteKind::diverging, 16, [=](double t) {
        const double s = 2 * t - 1, size = abs(s);
        return Oklch{0.97 - 0.54 * size, chroma * size, (s < 0 ? lowHue : highHue) * kDegree};
    });
}

std::vector<Palette> buildAll() {
    using enum PaletteKind;
    std::vector<Palette> all;
    // The project's ramp: lightness rises evenly from deep blue to the glowing boundary.
    all.push_back(
        table("versorium", sequential, {0x1d3461, 0x1f6f8b, 0x3aa99f, 0x9fd3a8, 0xfbf3d4}));
    // S. van der Walt and N. Smith, 2015 (CC0): every 17th of the 256 published colours.
    all.push_back(
        table("viridis", sequential,
              {0x440154, 0x481a6c, 0x472f7d, 0x414487, 0x39568c, 0x31688e, 0x2a788e, 0x23888e,
               0x1f988b, 0x22a884, 0x35b779, 0x54c568, 0x7ad151, 0xa5db36, 0xd2e21b, 0xfde725}));
    // J. Nuñez, C. Anderton and R. Renslow, 2018 (CC0): every 17th of the 256 published colours.
    all.push_back(
        table("cividis", sequential,
              {0x00224e, 0x002e6c, 0x1e3a6f, 0x35456c, 0x47516c, 0x575d6d, 0x666970, 0x757575,
               0x848279, 0x948e77, 0xa59c74, 0xb7a96e, 0xc8b866, 0xdbc75a, 0xeed649, 0xfee838}));
    all.push_back(table("grey", sequential, {0x000000, 0xffffff}));
    all.push_back(table("fire", sequential,
                        {0x0d0508, 0x4c0f22, 0x98211c, 0xd9531a, 0xf39c2b, 0xfbd868, 0xfff9dc}));
    all.push_back(twoArms("blue-red", 256, 25, 0.165));
    all.push_back(twoArms("purple-green", 312, 150, 0.12));
    // Day, blue evening, night, red morning: neutral at both turning points, so that the cycle is
    // smooth there too; the lightness is a cosine.
    all.push_back(law("dusk", cyclic, 32, [](double t) {
        const double turn = 360 * kDegree * t;
        return Oklch{0.56 + 0.35 * cos(turn), 0.125 * abs(sin(turn)),
                     (t < 0.5 ? 262 : 24) * kDegree};
    }));
    // All hues at one lightness and chroma: for phases beside which lightness means something else.
    all.push_back(law("hue", cyclic, 48, [](double t) {
        return Oklch{0.75, 0.115, (25 + 360 * t) * kDegree};
    }));
    // M. Okabe and K. Ito, 2008: eight colours that all common kinds of colour vision tell apart.
    all.push_back(
        table("okabe-ito", qualitative,
              {0x000000, 0xe69f00, 0x56b4e9, 0x009e73, 0xf0e442, 0x0072b2, 0xd55e00, 0xcc79a7}));
    return all;
}

const std::vector<Palette>& allPalettes() {
    static const std::vector<Palette> all = buildAll();
    return all;
}

}  // namespace

std::vector<std::string> paletteNames() {
    std::vector<std::string> names;
    for (const Palette& palette : allPalettes()) names.push_back(palette.name());
    return names;
}

Expected<Palette> paletteNamed(std::string_view name) {
    std::string all;
    for (const Palette& palette : allPalettes()) {
        if (palette.name() == name) return palette;
        all += (all.empty() ? "" : ", ") + palette.name();
    }
    return Status::usage("no palette is called \"" + std::string(name.substr(0, 60)) +
                         "\"; there are: " + all);
}

}  // namespace versorium
