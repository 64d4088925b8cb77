// SPDX-License-Identifier: MIT
#include "ui/session/studio_properties.h"

#include <algorithm>

#include "render/frame.h"
#include "ui/session/context.h"
#include "ui/session/shape_change.h"

namespace versorium {
namespace {

const PropertyTable<ExportOptions>& exportTable() {
    static const PropertyTable<ExportOptions> table{
        wholeOf(&ExportOptions::width,
                {.path = "width",
                 .alias = "export",
                 .label = trLater("pixels wide of an export"),
                 .help = trLater("The height follows from the shape of the view."),
                 .unit = "px",
                 .low = 16,
                 .high = kMostPixels,
                 .step = 100}),
        numberOf(&ExportOptions::millimetres,
                 {.path = "millimetres",
                  .label = trLater("mm wide of a plate"),
                  .help = trLater("One column of a journal is about 86 mm, two are 178 mm."),
                  .unit = "mm",
                  .low = 60,
                  .high = 2000,
                  .step = 1}),
        numberOf(&ExportOptions::dotsPerInch,
                 {.path = "dots_per_inch",
                  .label = trLater("pixels per inch of a plate"),
                  .help = trLater("300 for print, 150 for a screen or a slide."),
                  .low = 50,
                  .high = 2400,
                  .step = 5}),
        toggleOf(&ExportOptions::allViews,
                 {.path = "all_views",
                  .label = trLater("all views on a plate"),
                  .help = trLater("All views as panels of one plate, or the focused one alone.")}),
        toggleOf(&ExportOptions::title, {.path = "title",
                                         .label = trLater("title of a plate"),
                                         .help = trLater("The title above the panels.")}),
        toggleOf(&ExportOptions::caption,
                 {.path = "caption",
                  .label = trLater("caption of a plate"),
                  .help = trLater("The sentences below the panels: what was computed.")}),
    };
    return table;
}

const PropertyTable<RandomRoots>& randomTable() {
    static const PropertyTable<RandomRoots> table{
        wholeOf(&RandomRoots::least, {.path = "least",
                                      .alias = "random least",
                                      .label = trLater("least number of roots"),
                                      .help = trLater("How many roots are drawn, at least."),
                                      .low = 1,
                                      .high = kMostRandomRoots,
                                      .step = 1}),
        wholeOf(&RandomRoots::most, {.path = "most",
                                     .alias = "random most",
                                     .label = trLater("largest number of roots"),
                                     .help = trLater("How many roots are drawn, at most."),
                                     .low = 1,
                                     .high = kMostRandomRoots,
                                     .step = 1}),
        numberOf(&RandomRoots::lowPower, {.path = "low",
                                          .alias = "random low",
                                          .label = trLater("least power"),
                                          .help = trLater("Powers of the roots that are drawn."),
                                          .low = -20,
                                          .high = 20,
                                          .step = 0.5}),
        numberOf(&RandomRoots::highPower, {.path = "high",
                                           .alias = "random high",
                                           .label = trLater("largest power"),
                                           .help = trLater("Powers of the roots that are drawn."),
                                           .low = -20,
                                           .high = 20,
                                           .step = 0.5}),
        toggleOf(&RandomRoots::wholePowers,
                 {.path = "whole_powers",
                  .label = trLater("whole powers alone"),
                  .help = trLater("Powers are whole numbers, or any real ones.")}),
        wordOfEnum(&RandomRoots::arrangement,
                   {.path = "arrangement",
                    .alias = "random arrangement",
                    .label = trLater("arrangement of the roots"),
                    .help = trLater("Even, in clusters, or kept apart from each other.")}),
        wholeOf(&RandomRoots::clusters, {.path = "clusters",
                                         .alias = "random clusters",
                                         .label = trLater("clusters"),
                                         .help = trLater("How many clusters the roots form."),
                                         .low = 1,
                                         .high = 100,
                                         .step = 1}),
        numberOf(&RandomRoots::clusterRadius,
                 {.path = "cluster_size",
                  .alias = "random cluster size",
                  .label = trLater("size of a cluster"),
                  .help = trLater("As a part of the region in which the roots lie."),
                  .low = 0.001,
                  .high = 0.999,
                  .step = 0.05}),
        toggleOf(&RandomRoots::ball, {.path = "ball",
                                      .label = trLater("roots within a ball"),
                                      .help = trLater("In a ball, or in its box.")}),
    };
    return table;
}

const PropertyTable<RootDraw>& drawTable() {
    static const PropertyTable<RootDraw> table{
        wholeOf(&RootDraw::seed, {.path = "seed",
                                  .alias = "random seed",
                                  .label = trLater("seed of the random roots"),
                                  .help = trLater("The same seed draws the same roots."),
                                  .low = 0,
                                  .high = kMostSeed,
                                  .step = 1}),
    };
    return table;
}

const PropertyTable<ContactSheet>& sheetTable() {
    static const PropertyTable<ContactSheet> table{
        wholeOf(&ContactSheet::count, {.path = "candidates",
                                       .alias = "candidates",
                                       .label = trLater("candidates on the sheet"),
                                       .help = trLater("How many candidates are drawn at once."),
                                       .low = ContactSheet::kLeast,
                                       .high = ContactSheet::kMost,
                                       .step = 1}),
    };
    return table;
}

const PropertyTable<Drawing>& brushTable() {
    static const PropertyTable<Drawing> table{
        numberOf(&Drawing::alpha, {.path = "alpha",
                                   .alias = "modulation.alpha.brush",
                                   .label = trLater("α of the brush"),
                                   .help = trLater("The value that the brush paints."),
                                   .low = -kLargestModulated,
                                   .high = kLargestModulated,
                                   .sliderLow = 0,
                                   .sliderHigh = 300,
                                   .step = 5}),
        numberOf(&Drawing::beta, {.path = "beta",
                                  .alias = "modulation.beta.brush",
                                  .label = trLater("β of the brush"),
                                  .help = trLater("The value that the brush paints."),
                                  .low = -kLargestModulated,
                                  .high = kLargestModulated,
                                  .sliderLow = -0.5,
                                  .sliderHigh = 0.5,
                                  .step = 0.01}),
        numberOf(&Drawing::radius, {.path = "radius",
                                    .alias = "brush radius",
                                    .label = trLater("radius of the brush"),
                                    .help = trLater("In units of the shape."),
                                    .low = 1e-6,
                                    .high = 1e6,
                                    .sliderLow = 0.01,
                                    .sliderHigh = 1,
                                    .step = 0.02,
                                    .logarithmic = true}),
        toggleOf(&Drawing::erases, {.path = "erases",
                                    .label = trLater("erase"),
                                    .help = trLater("The brush takes paint away instead.")}),
        toggleOf(
            &Drawing::overlay,
            {.path = "overlay",
             .alias = "overlay",
             .label = trLater("show where α or β differ"),
             .help = trLater("Tints the views where α or β are not what they are elsewhere.")}),
    };
    return table;
}

// A value of a part of the studio; setting it draws a frame.
template <class Part>
void addPart(PropertyTable<StudioContext>& all, const PropertyTable<Part>& table,
             const std::string& path, Part& (*part)(StudioContext&)) {
    for (StudioProperty& property : liftedTable<StudioContext, Part>(table, path, part, false))
        all.push_back(std::move(property));
}

StudioProperty toggle(ValueInfo info, bool& (*of)(StudioContext&)) {
    info.kind = ValueKind::toggle;
    return {info,
            [of](const StudioContext& context) {
                return Json(of(const_cast<StudioContext&>(context)));  // only looked at
            },
            [of](StudioContext& context, const Json& json, const std::string& path) {
                return readToggle(json, of(context)).in(path);
            }};
}

// A word that is taken by a function.
StudioProperty word(ValueInfo info, std::vector<std::string> words,
                    std::string (*now)(const StudioContext&),
                    void (*take)(StudioContext&, const std::string&)) {
    info.kind = ValueKind::word;
    info.words = words;
    return {info, [now](const StudioContext& context) { return Json(now(context)); },
            [words, take](StudioContext& context, const Json& json, const std::string& path) {
                std::string wanted;
                const Status status = readWord(json, words, wanted);
                if (status.ok()) take(context, wanted);
                return status.in(path);
            }};
}

std::vector<std::string> themeNames() {
    std::vector<std::string> names;
    for (const StudioTheme& theme : themes()) names.push_back(theme.name);
    return names;
}

std::vector<std::string> languageIds() {
    std::vector<std::string> ids;
    for (const Language& language : languages()) ids.push_back(language.id);
    return ids;
}

void addWindow(PropertyTable<StudioContext>& all) {
    all.push_back(word(
        {.path = "theme",
         .label = trLater("theme"),
         .help = trLater("The colours of the studio: dark, light, or strong contrast "
                         "for a projector.")},
        themeNames(), [](const StudioContext& c) { return themes()[c.theme].name; },
        [](StudioContext& c, const std::string& name) { c.chooseTheme(name); }));
    all.push_back(word(
        {.path = "language",
         .label = trLater("language"),
         .help = trLater("Menus, messages, lessons and plates in this language.")},
        languageIds(), [](const StudioContext&) { return languageNow().id; },
        [](StudioContext& c, const std::string& id) { c.speak(id); }));
    all.push_back(word(
        {.path = "renderer",
         .label = trLater("who draws live pictures"),
         .help = trLater("Automatic takes whichever is faster and precise enough.")},
        wordsOf<RendererChoice>(),
        [](const StudioContext& c) { return std::string(wordOf(c.renderer)); },
        [](StudioContext& c, const std::string& word) {
            c.choose(*fromWord<RendererChoice>(word));
        }));
    all.push_back(toggle({.path = "images_are_layers",
                          .alias = "images are layers",
                          .label = trLater("opened images lie behind the fractal"),
                          .help = trLater("An image that is opened becomes a layer; else it "
                                          "becomes a shape.")},
                         [](StudioContext& c) -> bool& { return c.imagesAreLayers; }));
    all.push_back(
        toggle({.path = "animation.to_and_fro",
                .alias = "animate-to-and-fro",
                .label = trLater("the animation runs to and fro"),
                .help = trLater("Eased to and fro, or again and again from the low end.")},
               [](StudioContext& c) -> bool& { return c.player.animation.toAndFro; }));
    all.push_back(toggle({.path = "motion.again",
                          .alias = "play again",
                          .label = trLater("again from the beginning when it has ended"),
                          .help = trLater("The motion is played again and again.")},
                         [](StudioContext& c) -> bool& { return c.player.again; }));
}

}  // namespace

const PropertyTable<StudioContext>& studioProperties() {
    static const PropertyTable<StudioContext> all = [] {
        PropertyTable<StudioContext> table;
        addWindow(table);
        addPart<ExportOptions>(table, exportTable(), "export",
                               [](StudioContext& c) -> ExportOptions& { return c.exporting; });
        addPart<RootDraw>(table, drawTable(), "random",
                          [](StudioContext& c) -> RootDraw& { return c.versor.draw; });
        addPart<RandomRoots>(table, randomTable(), "random", [](StudioContext& c) -> RandomRoots& {
            return c.versor.draw.options;
        });
        addPart<ContactSheet>(table, sheetTable(), "sheet",
                              [](StudioContext& c) -> ContactSheet& { return c.sheet; });
        addPart<Drawing>(table, brushTable(), "brush",
                         [](StudioContext& c) -> Drawing& { return c.drawing; });
        return table;
    }();
    return all;
}

const StudioProperty* studioPropertyNamed(std::string_view path) {
    for (const StudioProperty& property : studioProperties())
        if (property.path == path) return &property;
    return nullptr;
}

}  // namespace versorium
