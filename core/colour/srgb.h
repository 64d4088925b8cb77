// SPDX-License-Identifier: MIT
#pragma once
// Colours and the spaces they are measured in. Everything is computed in linear light with the
// primaries and the white of sRGB (IEC 61966-2-1), where averaging and compositing are additions.
// "Encoded" or "display" values are the sRGB transfer of these, as files and #rrggbb carry them.
// OKLab (B. Ottosson, 2020) measures how different two colours look.
// Alpha is straight, never premultiplied.

#include <string>
#include <string_view>

#include "base/status.h"
#include "image/raster.h"

namespace versorium {

// Linear light, each in [0, 1] for what a screen can show; straight alpha.
struct Colour {
    double r = 0, g = 0, b = 0, a = 1;
    friend bool operator==(const Colour&, const Colour&) = default;
};

struct Oklab {
    double lightness = 0, a = 0, b = 0;
};
// The same in polar form; hue in radians.
struct Oklch {
    double lightness = 0, chroma = 0, hue = 0;
};

// The transfer curve of sRGB and its inverse, continued as an odd function below 0.
double linearFromSrgb(double encoded);
double srgbFromLinear(double linear);
// Rounded to the nearest of 0 … 255; NaN gives 0.
unsigned char srgbByte(double linear);

// Display values in [0, 1], or bytes, to linear light.
Colour colourFromSrgb(double r, double g, double b, double a = 1);
// "#rgb", "#rrggbb" or "#rrggbbaa".
Expected<Colour> colourFromHex(std::string_view text);
// A colour of the program's own tables: 0xrrggbb.
Colour colourFromRgb(unsigned rgb);
// "#rrggbb", or "#rrggbbaa" where the colour is not opaque.
std::string hexFromColour(const Colour& colour);

Oklab oklabFromColour(const Colour& colour);
Colour colourFromOklab(const Oklab& lab, double alpha = 1);
Oklab oklabFromOklch(const Oklch& lch);
// Euclidean distance in OKLab: about 0.02 is just visible between neighbouring patches.
double oklabDistance(const Colour& one, const Colour& other);

// Each part cut to [0, 1].
Colour clipped(const Colour& colour);
// (1 - t) one + t other, in linear light.
Colour mix(const Colour& one, const Colour& other, double t);

// A raster of linear RGB or straight-alpha RGBA as 8-bit sRGB with the same channels.
Raster<unsigned char> encodeSrgb(const Raster<float>& linear);

}  // namespace versorium
