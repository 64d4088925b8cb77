// SPDX-License-Identifier: MIT
// How an ensemble draws a list of roots, as properties.
#include <algorithm>

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

}  // namespace

const PropertyTable<EnsembleRoots>& ensembleRootsTable() {
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

}  // namespace versorium
