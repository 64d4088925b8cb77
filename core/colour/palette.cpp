// SPDX-License-Identifier: MIT
#include "colour/palette.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace versorium {
namespace {

constexpr std::array<const char*, 4> kKinds = {"sequential", "diverging", "cyclic", "qualitative"};
constexpr std::array<const char*, 2> kSpaces = {"oklab", "linear"};

template <std::size_t N>
std::size_t indexOf(const std::array<const char*, N>& words, const std::string& word) {
    std::size_t index = 0;
    while (index + 1 < N && word != words[index]) ++index;
    return index;
}

void readColour(ObjectReader& reader, const char* key, Colour& colour) {
    std::string text;
    reader.text(key, text);
    if (text.empty()) return;
    const Expected<Colour> read = colourFromHex(text);
    if (read)
        colour = *read;
    else
        reader.fail(key, read.status().message());
}

Expected<PaletteStop> readStop(const Json& value, double position, const std::string& path) {
    PaletteStop stop{.position = position, .colour = {}};
    if (value.is_string()) {
        const Expected<Colour> colour = colourFromHex(value.get<std::string>());
        if (!colour) return colour.status().in(path);
        stop.colour = *colour;
        return stop;
    }
    ObjectReader reader(value, path);
    reader.number("position", stop.position, 0, 1);
    if (!reader.has("colour")) reader.fail("colour", "the colour is missing");
    readColour(reader, "colour", stop.colour);
    if (Status status = reader.finish(); !status.ok()) return status;
    return stop;
}

}  // namespace

const char* wordOf(PaletteKind kind) { return kKinds[static_cast<std::size_t>(kind)]; }

Expected<Palette> Palette::make(std::string name, PaletteKind kind, PaletteSpace space,
                                std::vector<PaletteStop> stops) {
    const std::string where = "palette \"" + name + "\": ";
    if (stops.size() < 2 || stops.size() > kStopLimit)
        return Status::data(where + "2 to " + std::to_string(kStopLimit) + " stops are needed");
    for (std::size_t i = 0; i < stops.size(); ++i)
        if (!(stops[i].position >= (i == 0 ? 0 : stops[i - 1].position) && stops[i].position <= 1))
            return Status::data(where + "the positions of the stops must rise from 0 to 1");
    if (stops.front().position != 0 || stops.back().position != 1)
        return Status::data(where + "the first stop must stand at 0 and the last one at 1");
    if (kind == PaletteKind::cyclic &&
        oklabDistance(stops.front().colour, stops.back().colour) > 0.01)
        return Status::data(where + "the first and the last colour of a cycle must be the same");
    Palette palette;
    palette.name_ = std::move(name);
    palette.kind_ = kind;
    palette.space_ = space;
    for (const PaletteStop& stop : stops) {
        const Oklab lab = oklabFromColour(stop.colour);
        palette.nodes_.push_back(
            space == PaletteSpace::oklab
                ? Node{stop.position, lab.lightness, lab.a, lab.b, stop.colour.a}
                : Node{stop.position, stop.colour.r, stop.colour.g, stop.colour.b, stop.colour.a});
    }
    palette.stops_ = std::move(stops);
    return palette;
}

Colour Palette::at(double position) const {
    if (std::isnan(position) || nodes_.empty()) return undefined;
    if (kind_ == PaletteKind::cyclic) position -= std::floor(position);
    position = std::clamp(position, 0.0, 1.0);
    if (kind_ == PaletteKind::qualitative)
        return entry(
            std::min(static_cast<std::size_t>(position * static_cast<double>(nodes_.size())),
                     nodes_.size() - 1));
    const auto above =
        std::upper_bound(nodes_.begin(), nodes_.end(), position,
                         [](double p, const Node& node) { return p < node.position; });
    // At the ends, and on an infinite position of a cycle, the stop itself.
    if (above == nodes_.begin() || std::isnan(position)) return stops_.front().colour;
    if (above == nodes_.end()) return stops_.back().colour;
    const Node& q = *above;
    const Node& p = *(above - 1);
    const double t = (position - p.position) / (q.position - p.position);
    const double x = p.x + t * (q.x - p.x), y = p.y + t * (q.y - p.y), z = p.z + t * (q.z - p.z);
    const double alpha = p.alpha + t * (q.alpha - p.alpha);
    return space_ == PaletteSpace::oklab ? clipped(colourFromOklab({x, y, z}, alpha))
                                         : Colour{x, y, z, alpha};
}

Colour Palette::entry(std::size_t index) const {
    return stops_.empty() ? undefined : stops_[index % stops_.size()].colour;
}

Expected<Palette> paletteFromJson(const Json& value, const std::string& path) {
    ObjectReader reader(value, path);
    std::string name = "unnamed", kind = kKinds[0], space = kSpaces[0];
    Colour interior = Palette().interior, undefined = Palette().undefined;
    reader.text("name", name).word("kind", kind, {kKinds.begin(), kKinds.end()});
    reader.word("space", space, {kSpaces.begin(), kSpaces.end()});
    readColour(reader, "interior", interior);
    readColour(reader, "undefined", undefined);
    std::vector<PaletteStop> stops;
    const Json* list = reader.child("stops");
    if (!list || !list->is_array() || list->size() < 2 || list->size() > Palette::kStopLimit) {
        reader.fail("stops", "a list of 2 to " + std::to_string(Palette::kStopLimit) +
                                 " colours or {\"position\", \"colour\"} is expected");
    } else {
        for (std::size_t i = 0; i < list->size() && !reader.failed(); ++i) {
            const double even = static_cast<double>(i) / static_cast<double>(list->size() - 1);
            const auto stop =
                readStop((*list)[i], even, reader.pathOf("stops") + "[" + std::to_string(i) + "]");
            if (stop)
                stops.push_back(*stop);
            else
                reader.fail(stop.status());
        }
    }
    if (Status status = reader.finish(); !status.ok()) return status;
    Expected<Palette> palette =
        Palette::make(name, static_cast<PaletteKind>(indexOf(kKinds, kind)),
                      static_cast<PaletteSpace>(indexOf(kSpaces, space)), std::move(stops));
    if (!palette) return palette.status().in(path.empty() ? "stops" : path);
    palette->interior = interior;
    palette->undefined = undefined;
    return palette;
}

Json paletteToJson(const Palette& palette) {
    Json value;
    value["name"] = palette.name();
    value["kind"] = wordOf(palette.kind());
    value["space"] = kSpaces[static_cast<std::size_t>(palette.space())];
    value["interior"] = hexFromColour(palette.interior);
    value["undefined"] = hexFromColour(palette.undefined);
    Json stops = Json::array();
    for (const PaletteStop& stop : palette.stops()) {
        Json item;
        item["position"] = stop.position;
        item["colour"] = hexFromColour(stop.colour);
        stops.push_back(std::move(item));
    }
    value["stops"] = std::move(stops);
    return value;
}

}  // namespace versorium
