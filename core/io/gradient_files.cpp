// SPDX-License-Identifier: MIT
// Gradients: GIMP's .ggr, GMT's .cpt and Ultra Fractal's .ugr.
#include <algorithm>
#include <cmath>

#include "io/palette_parts.h"
#include "math/elementary.h"

namespace versorium {
namespace {

constexpr double kPi = 3.14159265358979323846;

// ---- GIMP

struct GimpSegment {
    double left, middle, right;
    std::array<double, 4> from, to;  // red, green, blue, opacity
    int blending, colouring;
};

// How far between the ends' colours the place t, from 0 to 1 in the segment, is.
double blended(const GimpSegment& segment, double t) {
    const double width = segment.right - segment.left;
    const double middle =
        width > 0 ? std::clamp((segment.middle - segment.left) / width, 1e-6, 1 - 1e-6) : 0.5;
    const double linear = t <= middle ? 0.5 * t / middle : 0.5 + 0.5 * (t - middle) / (1 - middle);
    switch (segment.blending) {
        case 1:  // curved
            return t <= 0 ? 0 : pow(t, log(0.5) / log(middle));
        case 2:  // sine
            return (1 - cos(kPi * linear)) / 2;
        case 3:  // spherical, increasing
            return sqrt(std::max(0.0, 1 - (linear - 1) * (linear - 1)));
        case 4:  // spherical, decreasing
            return 1 - sqrt(std::max(0.0, 1 - linear * linear));
        default:
            return linear;
    }
}

std::array<double, 3> hsvFromRgb(const std::array<double, 4>& rgb) {
    const double most = std::max({rgb[0], rgb[1], rgb[2]});
    const double range = most - std::min({rgb[0], rgb[1], rgb[2]});
    double hue = 0;
    if (range > 0) {
        if (most == rgb[0])
            hue = (rgb[1] - rgb[2]) / range;
        else if (most == rgb[1])
            hue = 2 + (rgb[2] - rgb[0]) / range;
        else
            hue = 4 + (rgb[0] - rgb[1]) / range;
    }
    return {60 * hue + (hue < 0 ? 360 : 0), most > 0 ? range / most : 0, most};
}

Colour colourIn(const GimpSegment& segment, double t) {
    const double f = blended(segment, t);
    const auto between = [f](double a, double b) { return a + f * (b - a); };
    const double opacity = between(segment.from[3], segment.to[3]);
    if (segment.colouring == 0)
        return colourFromSrgb(between(segment.from[0], segment.to[0]),
                              between(segment.from[1], segment.to[1]),
                              between(segment.from[2], segment.to[2]), opacity);
    std::array<double, 3> a = hsvFromRgb(segment.from), b = hsvFromRgb(segment.to);
    // 1 goes round the circle of hues towards green, 2 the other way.
    if (segment.colouring == 1 && b[0] <= a[0]) b[0] += 360;
    if (segment.colouring == 2 && b[0] >= a[0]) a[0] += 360;
    const std::array<double, 3> rgb =
        rgbFromHsv(between(a[0], b[0]), between(a[1], b[1]), between(a[2], b[2]));
    return colourFromSrgb(rgb[0], rgb[1], rgb[2], opacity);
}

Expected<GimpSegment> readSegment(TextScanner& scanner) {
    double numbers[13] = {};
    std::size_t count = 0;
    for (std::string_view word = scanner.word(); !word.empty() && count < 13;
         word = scanner.word()) {
        const std::optional<double> value = parseDecimal(word);
        if (!value) return paletteFault(scanner, numberFault(word));
        numbers[count++] = *value;
    }
    if (count < 11)
        return paletteFault(scanner,
                            "a segment has eleven numbers at least: left, middle, right, "
                            "and two colours with opacity");
    GimpSegment segment{numbers[0], numbers[1], numbers[2], {}, {}, 0, 0};
    for (std::size_t k = 0; k < 4; ++k) {
        segment.from[k] = std::clamp(numbers[3 + k], 0.0, 1.0);
        segment.to[k] = std::clamp(numbers[7 + k], 0.0, 1.0);
    }
    segment.blending = static_cast<int>(std::clamp(numbers[11], 0.0, 5.0));
    segment.colouring = static_cast<int>(std::clamp(numbers[12], 0.0, 2.0));
    if (!(segment.left >= 0 && segment.left <= segment.middle && segment.middle <= segment.right &&
          segment.right <= 1))
        return paletteFault(scanner, "the places of a segment must rise between 0 and 1");
    return segment;
}

std::vector<PaletteStop> stopsOf(const std::vector<GimpSegment>& segments) {
    std::vector<PaletteStop> stops;
    const auto parts =
        static_cast<int>(std::clamp<std::size_t>(Palette::kStopLimit / segments.size() - 2, 1, 16));
    for (const GimpSegment& segment : segments)
        for (int k = 0; k <= parts; ++k) {
            const double t = static_cast<double>(k) / parts;
            if (k > 0 && segment.right == segment.left) break;
            stops.push_back(
                {segment.left + t * (segment.right - segment.left), colourIn(segment, t)});
        }
    return stops;
}

// ---- GMT

std::optional<Colour> namedColour(std::string_view word) {
    struct Named {
        std::string_view name;
        unsigned rgb;
    };
    static constexpr Named kNames[] = {
        {"white", 0xffffff},  {"black", 0},       {"red", 0xff0000},     {"green", 0x00ff00},
        {"blue", 0x0000ff},   {"cyan", 0x00ffff}, {"magenta", 0xff00ff}, {"yellow", 0xffff00},
        {"gray", 0xbebebe},   {"grey", 0xbebebe}, {"orange", 0xffa500},  {"brown", 0xa52a2a},
        {"purple", 0xa020f0}, {"pink", 0xffc0cb}, {"navy", 0x000080},    {"darkgreen", 0x006400}};
    const std::string small = lowered(word.substr(0, 20));
    for (const Named& named : kNames)
        if (small == named.name) return colourFromRgb(named.rgb);
    return std::nullopt;
}

Colour colourOfTriple(const double (&triple)[3], bool hsv) {
    if (!hsv)
        return colourFromSrgb(std::clamp(triple[0] / 255, 0.0, 1.0),
                              std::clamp(triple[1] / 255, 0.0, 1.0),
                              std::clamp(triple[2] / 255, 0.0, 1.0));
    const auto rgb = rgbFromHsv(std::clamp(triple[0], 0.0, 360.0), std::clamp(triple[1], 0.0, 1.0),
                                std::clamp(triple[2], 0.0, 1.0));
    return colourFromSrgb(rgb[0], rgb[1], rgb[2]);
}

// A colour as r/g/b, h-s-v, #rrggbb, a name, or one number of grey.
std::optional<Colour> colourOfWord(const std::string& word, bool hsv) {
    if (const std::optional<Colour> colour = namedColour(word)) return colour;
    if (word.starts_with("#")) return hexColour(word);
    if (const std::optional<double> grey = parseDecimal(word)) {
        const double level = std::clamp(*grey / 255, 0.0, 1.0);
        return colourFromSrgb(level, level, level);
    }
    double triple[3] = {};
    std::size_t start = 0;
    const char separator = word.find('/') != std::string::npos ? '/' : '-';
    for (double& value : triple) {
        const std::size_t stop = std::min(word.find(separator, start), word.size());
        const std::optional<double> number =
            parseDecimal(word.substr(std::min(start, word.size()), stop - start));
        if (!number) return std::nullopt;
        value = *number;
        start = std::min(stop + 1, word.size());
    }
    return colourOfTriple(triple, hsv || separator == '-');
}

struct TableEntry {
    double at;
    Colour colour;
};

// A value and its colour, which takes one word or three.
Expected<TableEntry> takeEntry(const TextScanner& scanner, const std::vector<std::string>& words,
                               std::size_t& next, bool threeNumbers, bool hsv) {
    if (next >= words.size()) return paletteFault(scanner, "a value and its colour are missing");
    const std::optional<double> at = parseDecimal(words[next]);
    if (!at) return paletteFault(scanner, numberFault(words[next]));
    ++next;
    if (!threeNumbers) {
        if (next >= words.size()) return paletteFault(scanner, "a colour is missing");
        const std::optional<Colour> colour = colourOfWord(words[next], hsv);
        if (!colour) return paletteFault(scanner, shownWord(words[next]) + " is no colour");
        ++next;
        return TableEntry{*at, *colour};
    }
    double triple[3] = {};
    for (double& value : triple) {
        const std::optional<double> number =
            next < words.size() ? parseDecimal(words[next]) : std::nullopt;
        if (!number)
            return paletteFault(scanner, numberFault(next < words.size() ? words[next] : ""));
        value = *number;
        ++next;
    }
    return TableEntry{*at, colourOfTriple(triple, hsv)};
}

std::vector<std::string> wordsOfLine(TextScanner& scanner) {
    std::vector<std::string> words;
    for (std::string_view word = scanner.word(); !word.empty() && words.size() < 32;
         word = scanner.word()) {
        if (word[0] == ';') break;  // a label
        words.emplace_back(word);
    }
    // Marks of annotations.
    while (words.size() > 4 && words.back().size() == 1 &&
           std::string_view("LUBlub").find(words.back()[0]) != std::string_view::npos)
        words.pop_back();
    return words;
}

Expected<PaletteFile> paletteOfTable(const std::vector<TableEntry>& entries,
                                     const std::string& name,
                                     const std::optional<Colour>& undefined) {
    if (entries.size() < 2) return Status::data("the colour table has no slices");
    const double low = entries.front().at, high = entries.back().at;
    if (!(low < high) || !std::isfinite(high - low))
        return Status::data("the colour table's values must rise");
    std::vector<PaletteStop> stops;
    for (const TableEntry& entry : entries)
        stops.push_back({std::clamp((entry.at - low) / (high - low), 0.0, 1.0), entry.colour});
    stops.back().position = 1;
    Expected<Palette> palette =
        Palette::make(name, PaletteKind::sequential, PaletteSpace::oklab, std::move(stops));
    if (!palette) return palette.status();
    if (undefined) palette->undefined = *undefined;
    return PaletteFile{std::move(*palette),
                       "The table's values were spread over 0 to 1; the colours of what lies below "
                       "and above were left out."};
}

// ---- Ultra Fractal

constexpr double kUltraPlaces = 400;  // indices run round a circle of this length

std::optional<double> valueOf(std::string_view word, std::string_view key) {
    if (!beginsWithWord(word, key) || word.size() <= key.size() || word[key.size()] != '=')
        return std::nullopt;
    return parseDecimal(word.substr(key.size() + 1));
}

// The colour where the circle begins, between the last stop and the first one.
Colour colourAtSeam(const std::vector<PaletteStop>& stops) {
    const PaletteStop &last = stops.back(), &first = stops.front();
    const double gap = 1 - last.position + first.position;
    return gap > 0 ? mix(last.colour, first.colour, (1 - last.position) / gap) : first.colour;
}

Colour colourOfUltra(double value) {
    const auto number = static_cast<unsigned>(std::clamp(value, 0.0, 16777215.0));
    // Blue stands highest.
    return colourFromRgb((number & 0xff) << 16 | (number & 0xff00) | number >> 16);
}

}  // namespace

Expected<PaletteFile> readGimpGradient(std::string_view text, std::string name) {
    TextScanner scanner(text);
    while (scanner.nextLine() && scanner.rest().empty()) {
    }
    std::vector<GimpSegment> segments;
    bool counted = false;
    while (scanner.nextLine()) {
        const std::string_view rest = scanner.rest();
        if (rest.empty() || rest[0] == '#') continue;
        if (beginsWithWord(rest, "name:")) {
            scanner.word();
            if (!scanner.rest().empty()) name = std::string(scanner.rest().substr(0, 80));
            continue;
        }
        if (!counted && parseInteger(rest)) {
            counted = true;  // how many segments follow; they are counted themselves
            continue;
        }
        const Expected<GimpSegment> segment = readSegment(scanner);
        if (!segment) return segment.status();
        segments.push_back(*segment);
        if (segments.size() > Palette::kStopLimit / 3)
            return paletteFault(scanner, "there are too many segments");
    }
    if (segments.empty()) return Status::data("the gradient has no segments");
    Expected<Palette> palette =
        Palette::make(name, PaletteKind::sequential, PaletteSpace::oklab, stopsOf(segments));
    if (!palette) return palette.status();
    return PaletteFile{std::move(*palette), {}};
}

Expected<PaletteFile> readColourTable(std::string_view text, std::string name) {
    TextScanner scanner(text);
    std::vector<TableEntry> entries;
    std::optional<Colour> undefined;
    bool hsv = false;
    while (scanner.nextLine()) {
        if (const std::string_view line = scanner.rest(); line.starts_with("#")) {
            const bool names = line.find("COLOR_MODEL") != std::string_view::npos;
            if (names) hsv = lowered(line).find("hsv") != std::string::npos;
            continue;
        }
        const std::vector<std::string> words = wordsOfLine(scanner);
        if (words.empty()) continue;
        if (words[0] == "B" || words[0] == "F" || words[0] == "N") {
            if (words[0] != "N" || words.size() < 2) continue;
            undefined = colourOfWord(
                words.size() >= 4 ? words[1] + "/" + words[2] + "/" + words[3] : words[1], hsv);
            continue;
        }
        std::size_t next = 0;
        const bool three = words.size() >= 8;
        for (int end = 0; end < 2; ++end) {
            const Expected<TableEntry> entry = takeEntry(scanner, words, next, three, hsv);
            if (!entry) return entry.status();
            if (!entries.empty() && entry->at < entries.back().at)
                return paletteFault(scanner, "the table's values must rise");
            entries.push_back(*entry);
        }
        if (entries.size() > Palette::kStopLimit)
            return paletteFault(scanner, "there are too many slices");
    }
    return paletteOfTable(entries, name, undefined);
}

Expected<PaletteFile> readUltraGradient(std::string_view text, std::string name) {
    TextScanner scanner(text);
    std::vector<PaletteStop> stops;
    std::string section, note = "Opacity was left out, and colours run straight between the stops.";
    bool named = false;
    while (scanner.nextLine()) {
        std::string_view line = scanner.rest();
        if (line.empty() || line[0] == ';') continue;
        if (line[0] == '}' && !stops.empty()) {
            if (text.substr(scanner.offset()).find('{') != std::string_view::npos)
                note += " Only the first gradient of the file was read.";
            break;
        }
        if (!named && line.find('{') != std::string_view::npos) {
            std::string_view title = line.substr(0, line.find('{'));
            while (!title.empty() && (title.back() == ' ' || title.back() == '\t'))
                title.remove_suffix(1);
            if (!title.empty()) name = std::string(title.substr(0, 80));
            named = true;
            continue;
        }
        const std::string key = lowered(line.substr(0, 16));
        if (line.back() == ':') {
            section = key;
            continue;
        }
        if (section != "gradient:") continue;
        std::optional<double> index, colour;
        for (std::string_view word = scanner.word(); !word.empty(); word = scanner.word()) {
            if (const auto value = valueOf(word, "index")) index = value;
            if (const auto value = valueOf(word, "color")) colour = value;
        }
        if (!index || !colour) continue;
        double place = *index / kUltraPlaces;
        place -= std::floor(place);
        stops.push_back({std::isfinite(place) ? place : 0, colourOfUltra(*colour)});
        if (stops.size() + 2 > Palette::kStopLimit)
            return paletteFault(scanner, "there are too many colours");
    }
    if (stops.empty()) return Status::data("the gradient has no line with index= and color=");
    std::stable_sort(stops.begin(), stops.end(), [](const PaletteStop& a, const PaletteStop& b) {
        return a.position < b.position;
    });
    const Colour seam = colourAtSeam(stops);
    if (stops.front().position > 0) stops.insert(stops.begin(), {0, seam});
    if (stops.back().position < 1) stops.push_back({1, stops.front().colour});
    Expected<Palette> palette =
        Palette::make(name, PaletteKind::cyclic, PaletteSpace::oklab, std::move(stops));
    if (!palette) return palette.status();
    return PaletteFile{std::move(*palette), note};
}

}  // namespace versorium
