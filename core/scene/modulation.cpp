// SPDX-License-Identifier: MIT
#include "scene/modulation.h"

#include <cmath>

#include "scene/scene.h"
#include "scene/shape_name.h"

namespace versorium {
namespace {

constexpr double kFarthest = 1e6;

void readDiscs(ObjectReader& owner, std::vector<PaintedDisc>& discs) {
    const Json* found = owner.child("discs");
    if (!found) return;
    if (!found->is_array() || found->size() > kMostPaintedDiscs)
        return owner.fail("discs", "a list of at most " + std::to_string(kMostPaintedDiscs) +
                                       " discs is expected");
    for (std::size_t i = 0; i < found->size(); ++i) {
        const std::string path = owner.pathOf("discs") + "[" + std::to_string(i) + "]";
        const Json& row = (*found)[i];
        double numbers[5] = {};
        bool good = row.is_array() && row.size() == 5;
        for (std::size_t k = 0; good && k < 5; ++k) {
            good = row[k].is_number();
            if (good) numbers[k] = row[k].get<double>();
            good = good && std::abs(numbers[k]) <= (k == 4 ? kLargestModulated : kFarthest);
        }
        if (!good || !(numbers[3] >= 1e-6))
            return owner.fail(Status::data(
                path + ": five numbers are expected: x, y, z, radius (above 0) and value"));
        discs.push_back({numbers[0], numbers[1], numbers[2], numbers[3], numbers[4]});
    }
}

void readOne(ObjectReader& owner, const char* key, ModulationSpec& modulation) {
    const Json* found = owner.child(key);
    if (!found) return;
    ObjectReader reader(*found, owner.pathOf(key));
    std::vector<double> between{modulation.from, modulation.to};
    reader.text("shape", modulation.shape)
        .numbers("between", between, 2, 2)
        .number("value", modulation.value, -kLargestModulated, kLargestModulated);
    readDiscs(reader, modulation.discs);
    if (between.size() == 2 && !(between[0] < between[1] && std::abs(between[0]) <= kFarthest &&
                                 std::abs(between[1]) <= kFarthest))
        reader.fail("between", "two distances are expected, the smaller one first");
    if (between.size() == 2) modulation.from = between[0], modulation.to = between[1];
    owner.fail(reader.finish());
}

}  // namespace

void readModulation(ObjectReader& scene, ModulationSpec& alpha, ModulationSpec& beta) {
    const Json* found = scene.child("modulation");
    if (!found) return;
    ObjectReader reader(*found, scene.pathOf("modulation"));
    readOne(reader, "alpha", alpha);
    readOne(reader, "beta", beta);
    scene.fail(reader.finish());
}

Json modulationToJson(const ModulationSpec& modulation) {
    Json discs = Json::array();
    for (const PaintedDisc& disc : modulation.discs)
        discs.push_back(Json::array({disc.x, disc.y, disc.z, disc.radius, disc.value}));
    return Json{{"shape", modulation.shape},
                {"between", Json::array({modulation.from, modulation.to})},
                {"value", modulation.value},
                {"discs", discs}};
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
