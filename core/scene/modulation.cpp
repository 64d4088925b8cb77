// SPDX-License-Identifier: MIT
#include "scene/modulation.h"

#include <cmath>

#include "scene/properties.h"
#include "scene/shape_name.h"

namespace versorium {
namespace {

constexpr double kFarthest = 1e6;

Json discsToJson(const ModulationSpec& modulation) {
    Json discs = Json::array();
    for (const PaintedDisc& disc : modulation.discs)
        discs.push_back(Json::array({disc.x, disc.y, disc.z, disc.radius, disc.value}));
    return discs;
}

Status readDiscs(ModulationSpec& modulation, const Json& json, const std::string& path) {
    if (!json.is_array() || json.size() > kMostPaintedDiscs)
        return Status::data(path + ": a list of at most " + std::to_string(kMostPaintedDiscs) +
                            " discs is expected");
    std::vector<PaintedDisc> discs;
    for (std::size_t i = 0; i < json.size(); ++i) {
        const Json& row = json[i];
        double numbers[5] = {};
        bool good = row.is_array() && row.size() == 5;
        for (std::size_t k = 0; good && k < 5; ++k) {
            good = row[k].is_number();
            if (good) numbers[k] = row[k].get<double>();
            good = good && std::abs(numbers[k]) <= (k == 4 ? kLargestModulated : kFarthest);
        }
        if (!good || !(numbers[3] >= 1e-6))
            return Status::data(
                path + "[" + std::to_string(i) +
                "]: five numbers are expected: x, y, z, radius (above 0) and value");
        discs.push_back({numbers[0], numbers[1], numbers[2], numbers[3], numbers[4]});
    }
    modulation.discs = std::move(discs);
    return {};
}

Property<ModulationSpec> betweenProperty() {
    Property<ModulationSpec> between{
        {.path = "between",
         .kind = ValueKind::numbers,
         .label = trLater("between"),
         .help = trLater("Distances to the second shape, the smaller one first: the value up to "
                         "there, the parameter from there on; between them runs a cubic."),
         .least = 2,
         .most = 2}};
    between.get = [](const ModulationSpec& modulation) {
        return numbersToJson({modulation.from, modulation.to});
    };
    between.set = [](ModulationSpec& modulation, const Json& json,
                     const std::string& path) -> Status {
        std::vector<double> read;
        if (Status status = readNumbers(json, 2, 2, read); !status.ok()) return status.in(path);
        if (!(read[0] < read[1] && std::abs(read[0]) <= kFarthest &&
              std::abs(read[1]) <= kFarthest))
            return Status::data(path + ": two distances are expected, the smaller one first");
        modulation.from = read[0], modulation.to = read[1];
        return {};
    };
    ValueInfo from{.label = trLater("from distance"),
                   .help = trLater("Distance to the second shape up to which the number has that "
                                   "value."),
                   .low = -kFarthest,
                   .high = kFarthest,
                   .sliderLow = -1,
                   .sliderHigh = 1,
                   .step = 0.01};
    ValueInfo to = from;
    to.label = trLater("to distance");
    to.help = trLater("Distance from which on it has its usual value; between them runs a cubic.");
    return withComponents(between, {from, to});
}

}  // namespace

const PropertyTable<ModulationSpec>& modulationTable() {
    static const PropertyTable<ModulationSpec> table{
        textOf(&ModulationSpec::shape,
               {.path = "shape",
                .label = trLater("second shape"),
                .help = trLater("A shape within which the number has another value, as a text "
                                "like the map's own shape. Empty: none.")}),
        betweenProperty(),
        numberOf(&ModulationSpec::value, {.path = "value",
                                          .label = trLater("value in it"),
                                          .help = trLater("The number within the second shape."),
                                          .low = -kLargestModulated,
                                          .high = kLargestModulated,
                                          .sliderLow = -100,
                                          .sliderHigh = 100,
                                          .step = 1}),
        Property<ModulationSpec>{
            {.path = "discs",
             .label = trLater("painted discs"),
             .help = trLater("Painted one over the other: [x, y, z, radius, value].")},
            discsToJson,
            readDiscs},
    };
    return table;
}

Status checkModulation(const Scene& scene) {
    if (!scene.alphaOverSpace.modulates() && !scene.betaOverSpace.modulates()) return {};
    if (!mapOf(scene).info.field)
        return Status::data("modulation: the map \"" + scene.map +
                            "\" has no shape, so no alpha and beta over space");
    for (const auto& [name, spec] :
         {std::pair{"alpha", &scene.alphaOverSpace}, std::pair{"beta", &scene.betaOverSpace}})
        if (Status status = checkShapeText(spec->shape); !spec->shape.empty() && !status.ok())
            return status.in(std::string("modulation.") + name + ".shape");
    return {};
}

}  // namespace versorium
