// SPDX-License-Identifier: MIT
#include "io/palette_files.h"

#include <algorithm>
#include <cmath>

#include "io/known_formats.h"
#include "io/palette_parts.h"

namespace versorium {
namespace {

bool isHex(char c) {
    return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'f') || (c >= 'A' && c <= 'F');
}

// The file's name without folders and its ending.
std::string baseName(std::string_view path) {
    const std::size_t slash = path.find_last_of("/\\");
    if (slash != std::string_view::npos) path.remove_prefix(slash + 1);
    const std::size_t dot = path.rfind('.');
    if (dot != std::string_view::npos && dot > 0) path = path.substr(0, dot);
    return path.empty() ? "unnamed" : std::string(path.substr(0, 80));
}

// Lines of red, green and blue from 0 to 255; what follows is their name.
Expected<PaletteFile> readTriples(TextScanner scanner, std::string name) {
    std::vector<Colour> colours;
    while (scanner.nextLine()) {
        std::string_view word = scanner.word();
        if (word.empty() || word[0] == '#' || word[0] == ';') continue;
        const std::string key = lowered(word.substr(0, 16));
        if (key == "name:") {
            if (const std::string_view given = scanner.rest(); !given.empty())
                name = std::string(given.substr(0, 80));
            continue;
        }
        if (key == "columns:") continue;
        unsigned rgb = 0;
        for (int k = 0; k < 3; ++k) {
            const std::optional<std::int64_t> value = parseInteger(word);
            if (!value || *value < 0 || *value > 255)
                return paletteFault(
                    scanner,
                    "red, green and blue from 0 to 255 are expected, not " + shownWord(word));
            rgb = rgb << 8 | static_cast<unsigned>(*value);
            if (k < 2) word = scanner.word();
        }
        colours.push_back(colourFromRgb(rgb));
    }
    Expected<Palette> palette = paletteOfList(name, colours);
    if (!palette) return palette.status();
    return PaletteFile{std::move(*palette), {}};
}

bool isSeparator(char c) {
    return c == ' ' || c == ',' || c == ';' || c == '\t' || c == '"' || c == '\'' || c == '[' ||
           c == ']';
}

// Colours between blanks, commas, quotes and brackets. A line that begins with // or ; is passed
// over, and so is what stands alone after a #.
Expected<PaletteFile> readHexList(TextScanner scanner, const std::string& name) {
    std::vector<Colour> colours;
    while (scanner.nextLine()) {
        const std::string_view line = scanner.rest();
        if (line.starts_with("//") || line.starts_with(";") || line.starts_with("# ") ||
            line == "#")
            continue;
        for (std::size_t at = 0; at < line.size();) {
            while (at < line.size() && isSeparator(line[at])) ++at;
            std::size_t stop = at;
            while (stop < line.size() && !isSeparator(line[stop])) ++stop;
            if (stop == at) break;
            const std::optional<Colour> colour = hexColour(line.substr(at, stop - at));
            if (!colour)
                return paletteFault(scanner, "a colour #rrggbb is expected, not " +
                                                 shownWord(line.substr(at, stop - at)));
            colours.push_back(*colour);
            at = stop;
        }
    }
    Expected<Palette> palette = paletteOfList(name, colours);
    if (!palette) return palette.status();
    return PaletteFile{std::move(*palette), {}};
}

Expected<PaletteFile> readOwn(std::string_view text) {
    const Expected<Json> json = parseJson(std::string(text));
    if (!json) return json.status();
    Expected<Palette> palette = paletteFromJson(*json);
    if (!palette) return palette.status();
    return PaletteFile{std::move(*palette), {}};
}

enum class Format { none, own, gimpPalette, gimpGradient, jasc, ultra, table, triples, list };

// By the first line that says something.
Format formatOfLine(std::string_view line, std::string_view text, std::string_view name) {
    const bool gmt = text.find("COLOR_MODEL") != std::string_view::npos;
    if (hexColour(line.substr(0, line.find_first_of(" \t,;")))) return Format::list;
    if (line.starts_with("#") && line.find_first_of(" \t") != std::string_view::npos)
        return gmt ? Format::table : Format::none;
    TextScanner scanner(line);
    scanner.nextLine();
    std::size_t numbers = 0, words = 0, slashes = 0;
    bool whole = true;
    for (std::string_view word = scanner.word(); !word.empty(); word = scanner.word()) {
        ++words;
        slashes += word.find('/') != std::string_view::npos ? 1 : 0;
        if (words == numbers + 1 && parseDecimal(word)) {
            ++numbers;
            if (numbers <= 3) whole = whole && parseInteger(word);
        }
    }
    if (hasEnding(name, {".cpt"}) || gmt || numbers == 8 || (numbers >= 1 && slashes >= 2))
        return Format::table;
    if (numbers >= 3 && whole) return Format::triples;
    const bool quoted =
        line.find('#') != std::string_view::npos &&
        std::all_of(line.begin(), line.begin() + static_cast<std::ptrdiff_t>(line.find('#')),
                    isSeparator);
    return quoted ? Format::list : Format::none;
}

Format formatOf(std::string_view text, std::string_view name) {
    TextScanner scanner(text.substr(0, 1 << 16));
    while (scanner.nextLine()) {
        const std::string_view line = scanner.rest();
        if (line.empty() || line.starts_with(";") || line.starts_with("//")) continue;
        if (line.starts_with("{"))
            return text.find("\"stops\"") != std::string_view::npos ? Format::own : Format::none;
        if (beginsWithWord(line, "gimp palette")) return Format::gimpPalette;
        if (beginsWithWord(line, "gimp gradient")) return Format::gimpGradient;
        if (beginsWithWord(line, "jasc-pal")) return Format::jasc;
        if (line.find('{') != std::string_view::npos)
            return lowered(text.substr(0, 1 << 16)).find("gradient:") != std::string::npos
                       ? Format::ultra
                       : Format::none;
        const bool comment =
            line[0] == '#' && !hexColour(line.substr(0, line.find_first_of(" \t,;")));
        if (comment && formatOfLine(line, text, name) != Format::table) continue;
        return formatOfLine(line, text, name);
    }
    return Format::none;
}

}  // namespace

Status paletteFault(const TextScanner& scanner, const std::string& what) {
    return Status::data("line " + std::to_string(scanner.lineNumber()) +
                        " of the palette: " + what);
}

std::optional<Colour> hexColour(std::string_view word) {
    const bool marked = word.starts_with("#");
    if (marked)
        word.remove_prefix(1);
    else if (word.starts_with("0x") || word.starts_with("0X"))
        word.remove_prefix(2);
    const bool right = word.size() == 6 || word.size() == 8 || (marked && word.size() == 3);
    if (!right || !std::all_of(word.begin(), word.end(), isHex)) return std::nullopt;
    std::string full;
    for (const char c : word) full += word.size() == 3 ? std::string(2, c) : std::string(1, c);
    const Expected<Colour> colour = colourFromHex("#" + full);
    return colour ? std::optional<Colour>(*colour) : std::nullopt;
}

Expected<Palette> paletteOfList(const std::string& name, const std::vector<Colour>& colours) {
    if (colours.size() < 2 || colours.size() > Palette::kStopLimit)
        return Status::data("the palette has " + std::to_string(colours.size()) +
                            (colours.size() == 1 ? " colour; 2 to " : " colours; 2 to ") +
                            std::to_string(Palette::kStopLimit) + " are needed");
    std::vector<PaletteStop> stops;
    for (std::size_t i = 0; i < colours.size(); ++i)
        stops.push_back(
            {static_cast<double>(i) / static_cast<double>(colours.size() - 1), colours[i]});
    return Palette::make(name, PaletteKind::sequential, PaletteSpace::oklab, std::move(stops));
}

std::array<double, 3> rgbFromHsv(double hue, double saturation, double value) {
    const double sector = (hue / 60 - 6 * std::floor(hue / 360));
    std::array<double, 3> rgb{};
    for (std::size_t k = 0; k < 3; ++k) {
        double at = sector + (k == 0 ? 5 : k == 1 ? 3 : 1);
        at -= 6 * std::floor(at / 6);
        rgb[k] = value - value * saturation * std::clamp(std::min(at, 4 - at), 0.0, 1.0);
    }
    return rgb;
}

bool namesPalette(std::string_view name) {
    return hasEnding(name,
                     {".map", ".gpl", ".ggr", ".cpt", ".ugr", ".pal", ".hex", ".json", ".txt"});
}

bool looksLikePalette(std::span<const unsigned char> bytes) {
    const std::string_view text = textOf(bytes);
    if (!checkText(text.substr(0, 4096)).ok()) return false;
    return formatOf(text, {}) != Format::none;
}

Expected<PaletteFile> readPaletteFile(std::span<const unsigned char> bytes, std::string_view path) {
    const std::string_view text = textOf(bytes);
    if (Status status = foreignFault(bytes); !status.ok()) return status;
    if (Status status = checkText(text); !status.ok()) return status;
    const std::string name = baseName(path);
    TextScanner scanner(text);
    switch (formatOf(text, path)) {
        case Format::own:
            return readOwn(withoutMark(text));
        case Format::gimpPalette:
            while (scanner.nextLine() && scanner.rest().empty()) {
            }
            return readTriples(scanner, name);
        case Format::jasc:
            // Its name, its version and the number of colours.
            for (int k = 0; k < 3; ++k) scanner.nextLine();
            return readTriples(scanner, name);
        case Format::triples:
            return readTriples(scanner, name);
        case Format::list:
            return readHexList(scanner, name);
        case Format::gimpGradient:
            return readGimpGradient(text, name);
        case Format::table:
            return readColourTable(text, name);
        case Format::ultra:
            return readUltraGradient(text, name);
        case Format::none:
            break;
    }
    return Status::data(
        "not a palette that can be read here; JSON, .map, .gpl, .ggr, .pal, .cpt, .ugr and lists "
        "of #rrggbb can");
}

}  // namespace versorium
