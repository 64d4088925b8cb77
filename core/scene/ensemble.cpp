// SPDX-License-Identifier: MIT
#include "scene/ensemble.h"

#include <algorithm>

#include "scene/numbers.h"
#include "scene/properties.h"

namespace versorium {
namespace {

// Of the options that roots are drawn with; what makes no sense together is refused.
Property<EnsembleRoots> drawing(ValueInfo info, std::function<Json(const RandomRoots&)> get,
                                std::function<Status(RandomRoots&, const Json&)> set) {
    return {info, [get](const EnsembleRoots& roots) { return get(roots.draw); },
            [set](EnsembleRoots& roots, const Json& json, const std::string& path) {
                RandomRoots next = roots.draw;
                Status status = set(next, json);
                if (status.ok()) status = Status(checkRandomRoots(next));
                if (!status.ok()) return Status::data(path + ": " + status.message());
                roots.draw = next;
                return Status();
            }};
}

Property<EnsembleRoots> countProperty() {
    return withComponents(drawing(
                              {.path = "count",
                               .kind = ValueKind::numbers,
                               .label = trLater("roots"),
                               .help = trLater("How many roots a set has, at least and at most."),
                               .least = 2,
                               .most = 2},
                              [](const RandomRoots& draw) {
                                  return Json::array({draw.least, draw.most});
                              },
                              [](RandomRoots& draw, const Json& json) -> Status {
                                  std::vector<double> count;
                                  if (Status status = readNumbers(json, 2, 2, count); !status.ok())
                                      return status;
                                  for (double number : count)
                                      if (number != static_cast<int>(std::clamp(number, 0.0, 1e6)))
                                          return Status::data("two whole numbers are expected");
                                  draw.least = static_cast<int>(count[0]);
                                  draw.most = static_cast<int>(count[1]);
                                  return {};
                              }),
                          {{.kind = ValueKind::whole,
                            .label = trLater("roots, least"),
                            .help = trLater("How many roots a set has, at least and at most."),
                            .low = 1,
                            .high = kMostRandomRoots,
                            .sliderLow = 1,
                            .sliderHigh = 100,
                            .step = 1},
                           {.kind = ValueKind::whole,
                            .label = trLater("roots, most"),
                            .help = trLater("How many roots a set has, at least and at most."),
                            .low = 1,
                            .high = kMostRandomRoots,
                            .sliderLow = 1,
                            .sliderHigh = 100,
                            .step = 1}},
                          true);
}

Property<EnsembleRoots> powerProperty() {
    ValueInfo least{.label = trLater("power, least"),
                    .help = trLater("The least and the greatest power of a root."),
                    .low = -kLargestRootPower,
                    .high = kLargestRootPower,
                    .sliderLow = 0.5,
                    .sliderHigh = 10,
                    .step = 1};
    ValueInfo most = least;
    most.label = trLater("power, most");
    return withComponents(drawing(
                              {.path = "power",
                               .kind = ValueKind::numbers,
                               .label = trLater("power"),
                               .help = trLater("The least and the greatest power of a root."),
                               .least = 2,
                               .most = 2},
                              [](const RandomRoots& draw) {
                                  return numbersToJson({draw.lowPower, draw.highPower});
                              },
                              [](RandomRoots& draw, const Json& json) -> Status {
                                  std::vector<double> power;
                                  if (Status status = readNumbers(json, 2, 2, power); !status.ok())
                                      return status;
                                  draw.lowPower = power[0], draw.highPower = power[1];
                                  return {};
                              }),
                          {least, most});
}

// The half extents of a box of its own; empty: the box of the shape.
Property<EnsembleRoots> halfProperty() {
    ValueInfo extent{.label = trLater("half extent"),
                     .help = trLater("The region reaches so far from its centre along this axis."),
                     .low = 0,
                     .high = kLargestRootExtent,
                     .sliderLow = 0,
                     .sliderHigh = 2,
                     .step = 0.05};
    Property<EnsembleRoots> half{{.path = "half",
                                  .kind = ValueKind::numbers,
                                  .label = trLater("half extents"),
                                  .help = trLater("Half extents of the region. Empty: the box of "
                                                  "the shape."),
                                  .least = 0,
                                  .most = 4}};
    half.get = [](const EnsembleRoots& roots) {
        const auto& h = roots.draw.half;
        return roots.shapeBox ? Json::array() : numbersToJson({h.begin(), h.end()});
    };
    half.set = [](EnsembleRoots& roots, const Json& json, const std::string& path) -> Status {
        std::vector<double> extents;
        if (Status status = readNumbers(json, 0, 4, extents); !status.ok()) return status.in(path);
        EnsembleRoots next = roots;
        next.shapeBox = extents.empty();
        next.draw.half.fill(extents.empty() ? 0.5 : 0);
        std::copy(extents.begin(), extents.end(), next.draw.half.begin());
        if (Status status = checkRandomRoots(next.draw); !status.ok())
            return Status::data(path + ": " + status.message());
        roots = next;
        return {};
    };
    return withComponents(half, {extent, extent, extent, extent});
}

Property<EnsembleRoots> centreProperty() {
    Property<EnsembleRoots> centre{{.path = "center",
                                    .kind = ValueKind::numbers,
                                    .label = trLater("centre"),
                                    .help = trLater("The centre of the region, beside half extents "
                                                    "of its own."),
                                    .least = 0,
                                    .most = 4}};
    centre.get = [](const EnsembleRoots& roots) {
        const auto& c = roots.draw.centre;
        return roots.shapeBox ? Json::array() : numbersToJson({c.begin(), c.end()});
    };
    centre.set = [](EnsembleRoots& roots, const Json& json, const std::string& path) -> Status {
        std::vector<double> read;
        if (Status status = readNumbers(json, 0, 4, read); !status.ok()) return status.in(path);
        if (roots.shapeBox && !read.empty())
            return Status::data(path + ": stands beside \"half\" only");
        RandomRoots next = roots.draw;
        next.centre.fill(0);
        std::copy(read.begin(), read.end(), next.centre.begin());
        if (Status status = checkRandomRoots(next); !status.ok())
            return Status::data(path + ": " + status.message());
        roots.draw = next;
        return {};
    };
    return centre;
}

// Two words for a truth value, the first one for false.
Property<EnsembleRoots> drawWord(bool RandomRoots::*member, std::vector<std::string> words,
                                 ValueInfo info) {
    info.kind = ValueKind::word;
    info.words = words;
    return drawing(
        info,
        [member, words](const RandomRoots& draw) { return Json(words[draw.*member ? 1 : 0]); },
        [member, words](RandomRoots& draw, const Json& json) {
            std::string word;
            const Status status = readWord(json, words, word);
            if (status.ok()) draw.*member = word == words[1];
            return status;
        });
}

const PropertyTable<EnsembleRoots>& rootsTable() {
    static const PropertyTable<EnsembleRoots> table = [] {
        PropertyTable<EnsembleRoots> all{
            textOf(&EnsembleRoots::list, {.path = "list",
                                          .label = trLater("list"),
                                          .help = trLater("Which list of roots is drawn.")}),
            countProperty(),
            drawWord(&RandomRoots::ball, {"box", "ball"},
                     {.path = "region",
                      .label = trLater("region"),
                      .help = trLater("Roots fill the box, or the ball within it.")}),
            halfProperty(),
            centreProperty(),
            powerProperty(),
            drawWord(&RandomRoots::wholePowers, {"real", "whole"},
                     {.path = "powers",
                      .label = trLater("powers"),
                      .help = trLater("whole: 1, 2, 3 …; real: any number between the two.")}),
            drawing(
                {.path = "arrangement",
                 .kind = ValueKind::word,
                 .label = trLater("arranged"),
                 .help = trLater("even: each root anywhere. clustered: around a few centres. "
                                 "spread: far from one another."),
                 .words = wordsOf<RootArrangement>()},
                [](const RandomRoots& draw) { return Json(std::string(wordOf(draw.arrangement))); },
                [](RandomRoots& draw, const Json& json) {
                    std::string word;
                    const Status status = readWord(json, wordsOf<RootArrangement>(), word);
                    if (status.ok()) draw.arrangement = *fromWord<RootArrangement>(word);
                    return status;
                }),
            drawing(
                {.path = "clusters",
                 .kind = ValueKind::whole,
                 .label = trLater("clusters"),
                 .help = trLater("How many clusters there are."),
                 .low = 1,
                 .high = kMostRandomRoots,
                 .sliderLow = 1,
                 .sliderHigh = 20,
                 .step = 1},
                [](const RandomRoots& draw) { return Json(draw.clusters); },
                [](RandomRoots& draw, const Json& json) {
                    return readWhole(json, 1, kMostRandomRoots, draw.clusters);
                }),
            drawing(
                {.path = "cluster_radius",
                 .kind = ValueKind::number,
                 .label = trLater("their radius"),
                 .help = trLater("The radius of a cluster, in half extents of the region."),
                 .low = 1e-6,
                 .high = 1,
                 .sliderLow = 0.01,
                 .sliderHigh = 0.99,
                 .step = 0.05},
                [](const RandomRoots& draw) { return Json(draw.clusterRadius); },
                [](RandomRoots& draw, const Json& json) {
                    return readNumber(json, 1e-6, 1, draw.clusterRadius);
                }),
        };
        const auto clustered = [](const EnsembleRoots& roots) {
            return roots.draw.arrangement == RootArrangement::clustered;
        };
        all[8].shownWhen = all[9].shownWhen = clustered;
        return all;
    }();
    return table;
}

// Null, or an object.
Property<EnsembleSpec> rootsProperty() {
    Property<EnsembleSpec> roots{{.path = "roots",
                                  .kind = ValueKind::group,
                                  .label = trLater("random roots"),
                                  .help = trLater("A list of roots, and so the versor, that is "
                                                  "drawn anew for each set; or null.")}};
    roots.get = [](const EnsembleSpec& ensemble) {
        return ensemble.roots ? writeObject(*ensemble.roots, rootsTable()) : Json(nullptr);
    };
    roots.set = [](EnsembleSpec& ensemble, const Json& json, const std::string& path) -> Status {
        if (json.is_null()) {
            ensemble.roots.reset();
            return {};
        }
        EnsembleRoots next;
        if (Status status = readObject(next, rootsTable(), json, path); !status.ok()) return status;
        ensemble.roots = next;
        return {};
    };
    roots.parts = [](const EnsembleSpec& ensemble) -> PropertyTable<EnsembleSpec> {
        if (!ensemble.roots) return {};
        return liftedTable<EnsembleSpec, EnsembleRoots>(
            rootsTable(), "roots",
            [](EnsembleSpec& owner) -> EnsembleRoots& { return *owner.roots; }, false);
    };
    roots.home = Json(nullptr);
    return roots;
}

constexpr double kFarthestNumber = 1e150;

ValueInfo bound(const char* path, const char* label) {
    return {.path = path,
            .label = label,
            .help = trLater("A number of the map, drawn evenly from a range for each set."),
            .low = -kFarthestNumber,
            .high = kFarthestNumber,
            .step = 0.1};
}

ValueInfo nameInfo(const char* help) {
    return {.path = "name", .label = trLater("number"), .help = help};
}

const PropertyTable<EnsembleRange>& rangeTable() {
    static const PropertyTable<EnsembleRange> table{
        textOf(&EnsembleRange::name,
               nameInfo(trLater("Which number is drawn, by its name, such as alpha or c.re."))),
        numberOf(&EnsembleRange::from, bound("from", trLater("from"))),
        numberOf(&EnsembleRange::to, bound("to", trLater("to"))),
    };
    return table;
}

const PropertyTable<EnsembleDisc>& discTable() {
    static const PropertyTable<EnsembleDisc> table = [] {
        const char* help =
            trLater("A complex number of the map, drawn evenly from a disc for each set.");
        Property<EnsembleDisc> centre{{.path = "center",
                                       .kind = ValueKind::numbers,
                                       .label = trLater("centre"),
                                       .help = help,
                                       .least = 2,
                                       .most = 2}};
        centre.get = [](const EnsembleDisc& disc) {
            return numbersToJson({disc.centreRe, disc.centreIm});
        };
        centre.set = [](EnsembleDisc& disc, const Json& json, const std::string& path) -> Status {
            std::vector<double> read;
            if (Status status = readNumbers(json, 2, 2, read); !status.ok()) return status.in(path);
            disc.centreRe = read[0], disc.centreIm = read[1];
            return {};
        };
        const ValueInfo part{.help = help,
                             .low = -kFarthestNumber,
                             .high = kFarthestNumber,
                             .sliderLow = -2,
                             .sliderHigh = 2,
                             .step = 0.01};
        ValueInfo re = part, im = part;
        re.label = trLater("centre re");
        im.label = trLater("centre im");
        return PropertyTable<EnsembleDisc>{
            textOf(&EnsembleDisc::name,
                   nameInfo(trLater("Which complex number is drawn, by its name, such as c."))),
            withComponents(centre, {re, im}),
            numberOf(&EnsembleDisc::radius, {.path = "radius",
                                             .label = trLater("radius"),
                                             .help = help,
                                             .low = 0,
                                             .high = kFarthestNumber,
                                             .sliderLow = 0,
                                             .sliderHigh = 1,
                                             .step = 0.01}),
        };
    }();
    return table;
}

}  // namespace

const PropertyTable<EnsembleSpec>& ensembleTable() {
    static const PropertyTable<EnsembleSpec> table{
        wholeOf(&EnsembleSpec::count,
                {.path = "count",
                 .alias = "ensemble members",
                 .label = trLater("members"),
                 .help = trLater("How many sets are averaged. More go on from those that are "
                                 "counted."),
                 .low = 1,
                 .high = kMostMembers,
                 .sliderLow = 1,
                 .sliderHigh = 100000,
                 .step = 100,
                 .logarithmic = true}),
        wholeOf(&EnsembleSpec::seed,
                {.path = "seed",
                 .alias = "ensemble seed",
                 .label = trLater("seed"),
                 .help = trLater("Another seed is another sample; the same one gives the same "
                                 "bits."),
                 .low = 0,
                 .high = 2147483647,
                 .sliderLow = 0,
                 .sliderHigh = 1000,
                 .step = 1}),
        wordOfEnum(&EnsembleSpec::set,
                   {.path = "set",
                    .alias = "ensemble set",
                    .label = trLater("set"),
                    .help = trLater("The set that is averaged. membership: what has not escaped. "
                                    "solid: what a mesh would hold.")}),
        rootsProperty(),
        listOf(&EnsembleSpec::ranges, rangeTable,
               {.path = "ranges",
                .label = trLater("ranges"),
                .help = trLater("Numbers by name, each drawn evenly between from and to."),
                .most = kMostEnsembleNumbers}),
        listOf(&EnsembleSpec::discs, discTable,
               {.path = "discs",
                .label = trLater("discs"),
                .help = trLater("Complex numbers by name, each drawn evenly from a disc."),
                .most = kMostEnsembleNumbers}),
    };
    return table;
}

Status checkEnsemble(const Scene& scene) {
    const EnsembleSpec& ensemble = scene.ensemble;
    const MapInfo& info = mapOf(scene).info;
    const std::string drawn = ensemble.roots ? ensemble.roots->list : "";
    if (ensemble.roots && !scene.lists.contains(drawn))
        return Status::data("ensemble.roots.list: the map \"" + scene.map +
                            "\" has no list of roots named \"" + drawn + "\"");
    if (ensemble.roots && ensemble.roots->shapeBox && !info.field)
        return Status::data("ensemble.roots.half: the map \"" + scene.map +
                            "\" has no shape whose box could be taken; give half extents");
    const auto ofDrawnList = [&](const std::string& name) {
        const auto ref = numberNamed(scene, name);
        return ensemble.roots && ref && ref->kind == NumberKind::list && ref->list == drawn;
    };
    std::vector<std::string> names;
    for (const EnsembleRange& range : ensemble.ranges) names.push_back(range.name);
    for (const EnsembleDisc& disc : ensemble.discs) {
        names.push_back(disc.name + ".re");
        names.push_back(disc.name + ".im");
    }
    for (std::size_t i = 0; i < names.size(); ++i) {
        const std::string& name = names[i];
        if (!numberNamed(scene, name))
            return Status::data("ensemble: the map \"" + scene.map + "\" has no number named \"" +
                                name + "\"; it has " + numberNames(scene));
        if (std::find(names.begin(), names.begin() + static_cast<std::ptrdiff_t>(i), name) !=
            names.begin() + static_cast<std::ptrdiff_t>(i))
            return Status::data("ensemble: \"" + name + "\" is drawn twice");
        if (ofDrawnList(name))
            return Status::data("ensemble: \"" + name + "\" is of a list that is drawn itself");
    }
    for (const SliceAxis& axis : scene.slice.axes)
        for (const auto& [name, weight] : axis.terms)
            if (ofDrawnList(name) || std::find(names.begin(), names.end(), name) != names.end())
                return Status::data("ensemble: \"" + name +
                                    "\" is on an axis of the picture and cannot be drawn as well");
    for (const auto& [name, value] : scene.slice.origin)
        if (ofDrawnList(name))
            return Status::data("ensemble: \"" + name +
                                "\" of slice.origin is of a list that is drawn at random");
    return {};
}

void keepEnsembleFitting(Scene& scene) {
    EnsembleSpec& ensemble = scene.ensemble;
    std::erase_if(ensemble.ranges,
                  [&](const EnsembleRange& range) { return isOnAxis(scene.slice, range.name); });
    std::erase_if(ensemble.discs, [&](const EnsembleDisc& disc) {
        return isOnAxis(scene.slice, disc.name + ".re") || isOnAxis(scene.slice, disc.name + ".im");
    });
    if (!checkEnsemble(scene).ok()) ensemble.roots.reset();
}

}  // namespace versorium
