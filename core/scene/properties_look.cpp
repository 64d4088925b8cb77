// SPDX-License-Identifier: MIT
// The tables of what a picture looks like: colours, layers, the trap.
#include "colour/palette.h"
#include "scene/properties.h"

namespace versorium {
namespace {

Property<Gradient> displayColour(DisplayColour Gradient::*member, ValueInfo info) {
    info.kind = ValueKind::colour;
    return {
        info,
        [member](const Gradient& gradient) {
            const DisplayColour& c = gradient.*member;
            return numbersToJson({c.r, c.g, c.b, c.a});
        },
        [member](Gradient& gradient, const Json& json, const std::string& path) -> Status {
            std::vector<double> parts;
            if (Status status = readNumbers(json, 3, 4, parts); !status.ok())
                return status.in(path);
            for (double part : parts)
                if (!(part >= 0 && part <= 1))
                    return Status::data(path + ": every part lies in 0 to 1");
            gradient.*member = {parts[0], parts[1], parts[2], parts.size() > 3 ? parts[3] : 1.0};
            return {};
        }};
}

const PropertyTable<Gradient>& gradientTable() {
    static const PropertyTable<Gradient> table{
        displayColour(&Gradient::start,
                      {.path = "start",
                       .label = trLater("fast"),
                       .help = trLater("The colour of orbits that leave at once.")}),
        displayColour(&Gradient::finish, {.path = "finish",
                                          .label = trLater("slow"),
                                          .help = trLater("The colour of orbits that take long.")}),
        numberOf(&Gradient::exponent,
                 {.path = "exponent",
                  .label = trLater("colour exponent"),
                  .help = trLater("Above 1 the colours begin later, below 1 earlier."),
                  .low = 0.01,
                  .high = 100,
                  .sliderLow = 0.05,
                  .sliderHigh = 4,
                  .step = 0.1}),
    };
    return table;
}

// A name, or a palette as an object.
Property<Colouring> paletteProperty() {
    ValueInfo info{.path = "palette",
                   .kind = ValueKind::word,
                   .label = trLater("palette"),
                   .help = trLater("The colours that the field runs through.")};
    info.words = paletteNames();
    return {
        info,
        [](const Colouring& c) { return c.ownPalette.is_null() ? Json(c.palette) : c.ownPalette; },
        [](Colouring& c, const Json& json, const std::string& path) -> Status {
            if (!json.is_object()) {
                const Status status = readWord(json, paletteNames(), c.palette);
                if (status.ok()) c.ownPalette = nullptr;
                return status.in(path);
            }
            const Expected<Palette> palette = paletteFromJson(json, path);
            if (!palette) return palette.status();
            c.palette = palette->name();
            c.ownPalette = paletteToJson(*palette);
            return {};
        }};
}

Property<Colouring> rangeProperty() {
    ValueInfo info{.path = "range",
                   .kind = ValueKind::numbers,
                   .label = trLater("range"),
                   .help = trLater("The values at the two ends of the palette. Empty: the field's "
                                   "own."),
                   .least = 0,
                   .most = 2};
    return {info, [](const Colouring& c) { return numbersToJson(c.range); },
            [](Colouring& c, const Json& json, const std::string& path) -> Status {
                if (json.is_array() && json.empty()) {
                    c.range.clear();
                    return {};
                }
                return readNumbers(json, 2, 2, c.range).in(path);
            }};
}

Property<Colouring> outlineColourProperty() {
    ValueInfo info{.path = "outline_colour",
                   .kind = ValueKind::colour,
                   .label = trLater("outline's colour"),
                   .help = trLater("The colour of the outline and of contours, as #rrggbb.")};
    return {info, [](const Colouring& c) { return Json(c.outlineColour); },
            [](Colouring& c, const Json& json, const std::string& path) -> Status {
                std::string text;
                if (Status status = readText(json, text); !status.ok()) return status.in(path);
                if (!colourFromHex(text).ok())
                    return Status::data(path + ": \"" + text + "\" is not #rrggbb");
                c.outlineColour = text;
                return {};
            }};
}

// The field has a range and a scale of its own.
Property<Colouring> fieldProperty() {
    Property<Colouring> field =
        wordOfEnum(&Colouring::field, {.path = "field",
                                       .label = trLater("field"),
                                       .help = trLater("What is measured along each orbit.")});
    return field;
}

template <class Check>
Property<Colouring> when(Check applies, Property<Colouring> property) {
    property.shownWhen = applies;
    return property;
}

Property<Layer> layerSource() {
    ValueInfo info{.path = "source",
                   .kind = ValueKind::other,
                   .label = trLater("image"),
                   .help = trLater("leaf, #rrggbb, or asset: and a SHA-256. A list of them is a "
                                   "sequence of frames.")};
    return {info,
            [](const Layer& layer) -> Json {
                if (layer.sources.size() == 1) return layer.sources[0];
                Json frames = Json::array();
                for (const std::string& frame : layer.sources) frames.push_back(frame);
                return frames;
            },
            [](Layer& layer, const Json& json, const std::string& path) -> Status {
                std::vector<std::string> sources;
                if (json.is_array()) {
                    for (const Json& frame : json)
                        sources.push_back(frame.is_string() ? frame.get<std::string>() : "");
                    if (sources.empty() || sources.size() > kMostFrames)
                        return Status::data(path + ": must name 1 to " +
                                            std::to_string(kMostFrames) + " frames");
                } else {
                    sources.emplace_back();
                    if (Status status = readText(json, sources[0]); !status.ok())
                        return status.in(path);
                }
                for (const std::string& source : sources)
                    if (source != kLeafLayer && !source.starts_with("asset:") &&
                        !colourFromHex(source).ok())
                        return Status::data(path +
                                            ": \"leaf\", #rrggbb, or asset: and a SHA-256 is "
                                            "expected, or a list of such");
                layer.sources = std::move(sources);
                return {};
            }};
}

}  // namespace

const PropertyTable<Colouring>& colourTable() {
    const auto palette = [](const Colouring& c) { return c.rule == ColourRule::palette; };
    const auto gradient = [](const Colouring& c) { return c.rule == ColourRule::gradient; };
    const auto onPalette = [](const Colouring& c) {
        return c.rule != ColourRule::gradient && c.rule != ColourRule::versor;
    };
    static const PropertyTable<Colouring> table{
        wordOfEnum(&Colouring::rule,
                   {.path = "rule",
                    .label = trLater("colour by"),
                    .help = trLater("palette: a measured field on a palette. gradient: from fast "
                                    "to slow escape (A eqs 14-15). versor: the direction of f(z). "
                                    "phase: its angle. domain: the angle with edges of the "
                                    "modulus.")}),
        when(palette, fieldProperty()),
        when(onPalette, paletteProperty()),
        when(
            onPalette,
            toggleOf(&Colouring::reverse,
                     {.path = "reverse",
                      .label = trLater("reversed"),
                      .help = trLater("Runs through the palette from its end to its beginning.")})),
        when(palette,
             wordOfEnum(&Colouring::scale,
                        {.path = "scale",
                         .label = trLater("scale"),
                         .help = trLater("How values are spread over the palette, such as by "
                                         "their logarithm."),
                         .unsaid = trLater("the field's own")})),
        when(palette, rangeProperty()),
        when(palette,
             wordOfEnum(&Colouring::interior,
                        {.path = "interior",
                         .label = trLater("interior"),
                         .help = trLater("The set that takes the palette's interior colour, "
                                         "whatever the field says: membership is what never "
                                         "escapes.")})),
        when(gradient,
             groupOf(&Colouring::escaped, gradientTable,
                     {.path = "escaped",
                      .label = trLater("escaped"),
                      .help = trLater("The colours of orbits that escape: C_s, C_f and the "
                                      "exponent of A eqs 14-15.")})),
        when(gradient, groupOf(&Colouring::attracted, gradientTable,
                               {.path = "attracted",
                                .label = trLater("attracted"),
                                .help = trLater("The same for orbits that do not escape.")})),
        when(gradient,
             wordOfEnum(&Colouring::smoothing,
                        {.path = "smoothing",
                         .label = trLater("smoothing"),
                         .help = trLater("none shows the bands of whole steps (A eq 14). ratio "
                                         "(A eq 15) and log-log make them seamless.")})),
        wordOfEnum(&Colouring::outline,
                   {.path = "outline",
                    .label = trLater("outline"),
                    .help = trLater("A line round the set: membership is what never escapes, "
                                    "solid what is meshed.")}),
        outlineColourProperty(),
        numberOf(&Colouring::outlineWidth, {.path = "outline_width",
                                            .label = trLater("outline's width"),
                                            .help = trLater("In line widths of the medium."),
                                            .low = 0,
                                            .high = 100,
                                            .sliderLow = 0,
                                            .sliderHigh = 8,
                                            .step = 0.25}),
        numbersOf(&Colouring::contours,
                  {.path = "contours",
                   .label = trLater("contours"),
                   .help = trLater("Values of the field along which the outline's line runs."),
                   .least = 0,
                   .most = kMostContours}),
    };
    return table;
}

const PropertyTable<Layer>& layerTable() {
    static const PropertyTable<Layer> table = [] {
        PropertyTable<Layer> all{
            layerSource(),
            numberOf(&Layer::frame, {.path = "frame",
                                     .label = trLater("frame"),
                                     .help = trLater("Which frame of the sequence is shown. It "
                                                     "begins again after the last one."),
                                     .low = -1e9,
                                     .high = 1e9,
                                     .sliderLow = 0,
                                     .sliderHigh = 100,
                                     .step = 1,
                                     .moves = true}),
            toggleOf(&Layer::front,
                     {.path = "front",
                      .label = trLater("in front"),
                      .help = trLater("In front of the fractal; behind it otherwise.")}),
            numberOf(&Layer::x, {.path = "x",
                                 .label = trLater("to the right"),
                                 .help = trLater("The image's middle from the picture's, in "
                                                 "heights of the picture."),
                                 .low = -100,
                                 .high = 100,
                                 .sliderLow = -1,
                                 .sliderHigh = 1,
                                 .step = 0.05,
                                 .moves = true}),
            numberOf(&Layer::y, {.path = "y",
                                 .label = trLater("up"),
                                 .help = trLater("The image's middle from the picture's, in "
                                                 "heights of the picture."),
                                 .low = -100,
                                 .high = 100,
                                 .sliderLow = -1,
                                 .sliderHigh = 1,
                                 .step = 0.05,
                                 .moves = true}),
            numberOf(&Layer::scale,
                     {.path = "scale",
                      .label = trLater("size"),
                      .help = trLater("The image's height in heights of the picture."),
                      .low = 1e-3,
                      .high = 1000,
                      .sliderLow = 0.1,
                      .sliderHigh = 4,
                      .step = 0.05,
                      .logarithmic = true,
                      .moves = true}),
            numberOf(&Layer::opacity, {.path = "opacity",
                                       .label = trLater("opacity"),
                                       .help = trLater("0 lets everything through, 1 nothing."),
                                       .low = 0,
                                       .high = 1,
                                       .sliderLow = 0,
                                       .sliderHigh = 1,
                                       .step = 0.1,
                                       .moves = true}),
        };
        all[1].shownWhen = [](const Layer& layer) { return layer.sources.size() > 1; };
        return all;
    }();
    return table;
}

const PropertyTable<TrapSpec>& trapTable() {
    static const PropertyTable<TrapSpec> table{
        wordOfEnum(&TrapSpec::kind, {.path = "kind",
                                     .label = trLater("trap"),
                                     .help = trLater("What the field trap measures the distance "
                                                     "to: a point, a line or a circle.")}),
        numbersOf(&TrapSpec::point,
                  {.path = "point",
                   .label = trLater("trap's point"),
                   .help = trLater("The point, a point of the line, or the circle's centre."),
                   .least = 1,
                   .most = 4}),
        numberOf(&TrapSpec::radius, {.path = "radius",
                                     .label = trLater("trap's radius"),
                                     .help = trLater("Of a circle."),
                                     .low = 0,
                                     .high = 1e6,
                                     .sliderLow = 0,
                                     .sliderHigh = 4,
                                     .step = 0.05}),
        numberOf(&TrapSpec::angle, {.path = "angle",
                                    .label = trLater("trap's angle"),
                                    .help = trLater("Of a line, from the first axis."),
                                    .unit = trLater("radians"),
                                    .low = -1e3,
                                    .high = 1e3,
                                    .sliderLow = -3.2,
                                    .sliderHigh = 3.2,
                                    .step = 0.05}),
    };
    return table;
}

}  // namespace versorium
