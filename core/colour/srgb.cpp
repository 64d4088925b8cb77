// SPDX-License-Identifier: MIT
#include "colour/srgb.h"

#include <algorithm>
#include <array>

#include "math/elementary.h"

namespace versorium {
namespace {

double cubeRoot(double x) {
    if (x == 0) return x;
    return x < 0 ? -pow(-x, 1.0 / 3.0) : pow(x, 1.0 / 3.0);
}

// thresholds[k] is the least linear value that rounds to k + 1.
std::array<double, 255> byteThresholds() {
    std::array<double, 255> thresholds{};
    for (int k = 0; k < 255; ++k)
        thresholds[static_cast<std::size_t>(k)] = linearFromSrgb((k + 0.5) / 255);
    return thresholds;
}

int hexDigit(char c) {
    if (c >= '0' && c <= '9') return c - '0';
    if (c >= 'a' && c <= 'f') return c - 'a' + 10;
    if (c >= 'A' && c <= 'F') return c - 'A' + 10;
    return -1;
}

unsigned char alphaByte(double alpha) {
    return static_cast<unsigned char>(std::clamp(alpha, 0.0, 1.0) * 255 + 0.5);
}

}  // namespace

double linearFromSrgb(double encoded) {
    if (encoded < 0) return -linearFromSrgb(-encoded);
    return encoded <= 0.04045 ? encoded / 12.92 : pow((encoded + 0.055) / 1.055, 2.4);
}

double srgbFromLinear(double linear) {
    if (linear < 0) return -srgbFromLinear(-linear);
    return linear <= 0.0031308 ? linear * 12.92 : 1.055 * pow(linear, 1 / 2.4) - 0.055;
}

unsigned char srgbByte(double linear) {
    static const std::array<double, 255> thresholds = byteThresholds();
    if (!(linear > 0)) return 0;
    return static_cast<unsigned char>(
        std::upper_bound(thresholds.begin(), thresholds.end(), linear) - thresholds.begin());
}

Colour colourFromSrgb(double r, double g, double b, double a) {
    return {linearFromSrgb(r), linearFromSrgb(g), linearFromSrgb(b), a};
}

Colour colourFromRgb(unsigned rgb) {
    return colourFromSrgb((rgb >> 16 & 255) / 255.0, (rgb >> 8 & 255) / 255.0, (rgb & 255) / 255.0);
}

Expected<Colour> colourFromHex(std::string_view text) {
    const Status wrong = Status::data("\"" + std::string(text.substr(0, 40)) +
                                      "\" is not a colour: write #rrggbb or #rrggbbaa");
    if (text.empty() || text[0] != '#') return wrong;
    text.remove_prefix(1);
    std::array<int, 8> digits{};
    if (text.size() != 3 && text.size() != 6 && text.size() != 8) return wrong;
    for (std::size_t i = 0; i < text.size(); ++i) {
        digits[i] = hexDigit(text[i]);
        if (digits[i] < 0) return wrong;
    }
    std::array<double, 4> value{0, 0, 0, 1};
    const bool brief = text.size() == 3;
    for (std::size_t i = 0; i < (brief ? 3 : text.size() / 2); ++i)
        value[i] = (brief ? digits[i] * 17 : digits[2 * i] * 16 + digits[2 * i + 1]) / 255.0;
    return colourFromSrgb(value[0], value[1], value[2], value[3]);
}

std::string hexFromColour(const Colour& colour) {
    static const char* const kDigits = "0123456789abcdef";
    std::string text = "#";
    const auto add = [&](unsigned char byte) {
        text += kDigits[byte >> 4];
        text += kDigits[byte & 15];
    };
    for (const double value : {colour.r, colour.g, colour.b}) add(srgbByte(value));
    if (alphaByte(colour.a) != 255) add(alphaByte(colour.a));
    return text;
}

// Ottosson's matrices from linear sRGB to cone responses and from their cube roots to Lab.
Oklab oklabFromColour(const Colour& c) {
    const double l = cubeRoot(0.4122214708 * c.r + 0.5363325363 * c.g + 0.0514459929 * c.b);
    const double m = cubeRoot(0.2119034982 * c.r + 0.6806995451 * c.g + 0.1073969566 * c.b);
    const double s = cubeRoot(0.0883024619 * c.r + 0.2817188376 * c.g + 0.6299787005 * c.b);
    return {0.2104542553 * l + 0.7936177850 * m - 0.0040720468 * s,
            1.9779984951 * l - 2.4285922050 * m + 0.4505937099 * s,
            0.0259040371 * l + 0.7827717662 * m - 0.8086757660 * s};
}

Colour colourFromOklab(const Oklab& lab, double alpha) {
    const double l = lab.lightness + 0.3963377774 * lab.a + 0.2158037573 * lab.b;
    const double m = lab.lightness - 0.1055613458 * lab.a - 0.0638541728 * lab.b;
    const double s = lab.lightness - 0.0894841775 * lab.a - 1.2914855480 * lab.b;
    const double l3 = l * l * l, m3 = m * m * m, s3 = s * s * s;
    return {4.0767416621 * l3 - 3.3077115913 * m3 + 0.2309699292 * s3,
            -1.2684380046 * l3 + 2.6097574011 * m3 - 0.3413193965 * s3,
            -0.0041960863 * l3 - 0.7034186147 * m3 + 1.7076147010 * s3, alpha};
}

Oklab oklabFromOklch(const Oklch& lch) {
    return {lch.lightness, lch.chroma * cos(lch.hue), lch.chroma * sin(lch.hue)};
}

double oklabDistance(const Colour& one, const Colour& other) {
    const Oklab p = oklabFromColour(one), q = oklabFromColour(other);
    const double dl = p.lightness - q.lightness, da = p.a - q.a, db = p.b - q.b;
    return sqrt(dl * dl + da * da + db * db);
}

Colour clipped(const Colour& colour) {
    const auto clip = [](double value) { return value > 0 ? (value < 1 ? value : 1.0) : 0.0; };
    return {clip(colour.r), clip(colour.g), clip(colour.b), clip(colour.a)};
}

Colour mix(const Colour& one, const Colour& other, double t) {
    const double rest = 1 - t;
    return {rest * one.r + t * other.r, rest * one.g + t * other.g, rest * one.b + t * other.b,
            rest * one.a + t * other.a};
}

Raster<unsigned char> encodeSrgb(const Raster<float>& linear) {
    Raster<unsigned char> out(linear.size(), linear.channels());
    const auto channels = static_cast<std::size_t>(linear.channels());
    const std::vector<float>& from = linear.values();
    for (std::size_t i = 0; i < from.size(); ++i)
        out.values()[i] = channels == 4 && i % 4 == 3 ? alphaByte(static_cast<double>(from[i]))
                                                      : srgbByte(static_cast<double>(from[i]));
    return out;
}

}  // namespace versorium
