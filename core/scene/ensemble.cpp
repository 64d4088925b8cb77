// SPDX-License-Identifier: MIT
#include "scene/ensemble.h"

#include <algorithm>

#include "scene/numbers.h"

namespace versorium {
namespace {

const std::vector<std::string> kArrangements{"even", "clustered", "spread"};

void readRoots(const Json& value, const std::string& path, ObjectReader& owner,
               EnsembleRoots& roots) {
    ObjectReader reader(value, path);
    RandomRoots& draw = roots.draw;
    std::vector<double> count{10, 10}, power{1, 3}, half, centre;
    std::string region = "box", powers = "whole", arrangement = "even";
    reader.text("list", roots.list)
        .numbers("count", count, 2, 2)
        .word("region", region, {"box", "ball"})
        .numbers("half", half, 0, 4)
        .numbers("center", centre, 0, 4)
        .numbers("power", power, 2, 2)
        .word("powers", powers, {"whole", "real"})
        .word("arrangement", arrangement, kArrangements)
        .integer("clusters", draw.clusters, 1, kMostRandomRoots)
        .number("cluster_radius", draw.clusterRadius, 1e-6, 1);
    owner.fail(reader.finish());
    if (owner.failed()) return;
    for (double number : count)
        if (number != static_cast<int>(std::clamp(number, 0.0, 1e6)))
            return owner.fail(Status::data(path + ".count: two whole numbers are expected"));
    draw.least = static_cast<int>(count[0]);
    draw.most = static_cast<int>(count[1]);
    draw.ball = region == "ball";
    draw.lowPower = power[0];
    draw.highPower = power[1];
    draw.wholePowers = powers == "whole";
    draw.arrangement = arrangement == "clustered" ? RootArrangement::clustered
                       : arrangement == "spread"  ? RootArrangement::spread
                                                  : RootArrangement::even;
    roots.shapeBox = half.empty();
    if (half.empty() && !centre.empty())
        return owner.fail(Status::data(path + ".center: stands beside \"half\" only"));
    draw.half.fill(0.5);
    if (!half.empty()) draw.half.fill(0);
    std::copy(half.begin(), half.end(), draw.half.begin());
    std::copy(centre.begin(), centre.end(), draw.centre.begin());
    if (Status status = checkRandomRoots(draw); !status.ok())
        owner.fail(Status::data(path + "." + status.message()));
}

// A list of objects, each read by `one`.
template <class Item, class ReadOne>
void readList(ObjectReader& owner, const char* key, std::vector<Item>& items, ReadOne one) {
    const Json* found = owner.child(key);
    if (!found) return;
    items.clear();
    if (!found->is_array() || found->size() > kMostEnsembleNumbers)
        return owner.fail(
            key, "a list of at most " + std::to_string(kMostEnsembleNumbers) + " is expected");
    for (std::size_t i = 0; i < found->size(); ++i) {
        ObjectReader reader((*found)[i], owner.pathOf(key) + "[" + std::to_string(i) + "]");
        Item item;
        one(reader, item);
        owner.fail(reader.finish());
        items.push_back(item);
    }
}

Json list(std::initializer_list<double> numbers) {
    Json json = Json::array();
    for (double number : numbers) json.push_back(number);
    return json;
}

}  // namespace

void readEnsemble(ObjectReader& scene, EnsembleSpec& ensemble) {
    const Json* found = scene.child("ensemble");
    if (!found) return;
    ObjectReader reader(*found, scene.pathOf("ensemble"));
    reader.integer("count", ensemble.count, 1, kMostMembers)
        .integer("seed", ensemble.seed, 0, 2147483647)
        .word("set", ensemble.set, {"membership", "solid"});
    if (const Json* roots = reader.child("roots"); roots && !roots->is_null()) {
        ensemble.roots.emplace();
        readRoots(*roots, reader.pathOf("roots"), reader, *ensemble.roots);
    }
    readList(reader, "ranges", ensemble.ranges, [](ObjectReader& one, EnsembleRange& range) {
        one.text("name", range.name)
            .number("from", range.from, -1e150, 1e150)
            .number("to", range.to, -1e150, 1e150);
    });
    readList(reader, "discs", ensemble.discs, [](ObjectReader& one, EnsembleDisc& disc) {
        std::vector<double> centre{0, 0};
        one.text("name", disc.name)
            .numbers("center", centre, 2, 2)
            .number("radius", disc.radius, 0, 1e150);
        if (centre.size() == 2) disc.centreRe = centre[0], disc.centreIm = centre[1];
    });
    scene.fail(reader.finish());
}

Json ensembleToJson(const EnsembleSpec& ensemble) {
    Json json{{"count", ensemble.count}, {"seed", ensemble.seed}, {"set", ensemble.set}};
    json["roots"] = nullptr;
    if (ensemble.roots) {
        const RandomRoots& draw = ensemble.roots->draw;
        const auto& h = draw.half;
        const auto& c = draw.centre;
        const bool own = !ensemble.roots->shapeBox;
        json["roots"] =
            Json{{"list", ensemble.roots->list},
                 {"count", Json::array({draw.least, draw.most})},
                 {"region", draw.ball ? "ball" : "box"},
                 {"half", own ? list({h[0], h[1], h[2], h[3]}) : Json::array()},
                 {"center", own ? list({c[0], c[1], c[2], c[3]}) : Json::array()},
                 {"power", list({draw.lowPower, draw.highPower})},
                 {"powers", draw.wholePowers ? "whole" : "real"},
                 {"arrangement", kArrangements[static_cast<std::size_t>(draw.arrangement)]},
                 {"clusters", draw.clusters},
                 {"cluster_radius", draw.clusterRadius}};
    }
    json["ranges"] = Json::array();
    for (const EnsembleRange& range : ensemble.ranges)
        json["ranges"].push_back(
            Json{{"name", range.name}, {"from", range.from}, {"to", range.to}});
    json["discs"] = Json::array();
    for (const EnsembleDisc& disc : ensemble.discs)
        json["discs"].push_back(Json{{"name", disc.name},
                                     {"center", list({disc.centreRe, disc.centreIm})},
                                     {"radius", disc.radius}});
    return json;
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
