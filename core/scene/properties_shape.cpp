// SPDX-License-Identifier: MIT
// The table of the shape: what it is and how its grid is made.
#include "colour/palette.h"
#include "scene/properties.h"

namespace versorium {
namespace {

// Not written where it is as it is in every other scene.
template <class Member>
Property<ShapeSpec> unlessHome(Property<ShapeSpec> property, Member ShapeSpec::*member) {
    property.omitted = [member](const ShapeSpec& spec) {
        return spec.*member == ShapeSpec{}.*member;
    };
    return property;
}

}  // namespace

const PropertyTable<ShapeSpec>& shapeTable() {
    static const PropertyTable<ShapeSpec> table{
        textOf(&ShapeSpec::source,
               {.path = "source",
                .alias = "shape",
                .label = trLater("shape"),
                .help = trLater("A shape as a text, such as disc(0.5) or polygon(x1, y1, …); the "
                                "name of a built-in mesh; or asset: and a SHA-256.")}),
        wholeOf(&ShapeSpec::resolution,
                {.path = "resolution",
                 .label = trLater("grid"),
                 .help = trLater("Nodes along an edge of the grid that is made of a mesh or an "
                                 "image."),
                 .low = 8,
                 .high = 512,
                 .sliderLow = 16,
                 .sliderHigh = 256,
                 .step = 8}),
        numberOf(&ShapeSpec::padding, {.path = "padding",
                                       .label = trLater("free cells"),
                                       .help = trLater("Free cells of the grid around a mesh."),
                                       .unit = trLater("cells"),
                                       .low = 0,
                                       .high = 100,
                                       .sliderLow = 0,
                                       .sliderHigh = 20,
                                       .step = 1}),
        wordOfEnum(&ShapeSpec::outside,
                   {.path = "outside",
                    .label = trLater("outside"),
                    .help = trLater("Beyond a grid's box: the value at its border, or that and the "
                                    "distance to the box. Empty: border for a loaded grid, else "
                                    "distance."),
                    .unsaid = trLater("the source's own")}),
        toggleOf(&ShapeSpec::zFastest, {.path = "z_fastest",
                                        .label = trLater("z first"),
                                        .help = trLater("A loaded .f3d file runs along z first.")}),
        unlessHome(numberOf(&ShapeSpec::threshold,
                            {.path = "threshold",
                             .label = trLater("threshold"),
                             .help = trLater("Of a picture: inside is what is darker than this "
                                             "share of white, or at least as opaque."),
                             .low = 0,
                             .high = 1,
                             .sliderLow = 0,
                             .sliderHigh = 1,
                             .step = 0.05}),
                   &ShapeSpec::threshold),
        unlessHome(toggleOf(&ShapeSpec::byAlpha,
                            {.path = "by_alpha",
                             .label = trLater("by opacity"),
                             .help = trLater("Of a picture: inside is what is opaque, whatever "
                                             "its colour.")}),
                   &ShapeSpec::byAlpha),
        unlessHome(toggleOf(&ShapeSpec::invert,
                            {.path = "invert",
                             .label = trLater("inverted"),
                             .help = trLater("Of a picture: inside is what is light, or "
                                             "transparent.")}),
                   &ShapeSpec::invert),
    };
    return table;
}

}  // namespace versorium
