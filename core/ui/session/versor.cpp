// SPDX-License-Identifier: MIT
#include "ui/session/versor.h"

#include <algorithm>

#include "render/root_region.h"
#include "scene/shape_controls.h"
#include "ui/session/context.h"

namespace versorium {
namespace {

std::size_t at(int item) { return static_cast<std::size_t>(item); }

// Whether a name such as "roots[7].x" speaks of this item of the list or of one after it.
bool speaksFrom(const std::string& name, const std::string& list, int item) {
    const std::string begin = list + "[";
    return name.starts_with(begin) && std::atoi(name.c_str() + begin.size()) >= item;
}

// Items from this one on may go, as far as names are concerned.
Status mayLose(const Workspace& workspace, const std::string& list, int item) {
    const auto refused = [&](const std::string& name, const char* user) {
        return Status::usage("\"" + name + "\" is " + user + ": take it from there first");
    };
    for (const Scene& scene : workspace.views) {
        for (const SliceAxis& axis : scene.slice.axes)
            for (const auto& [name, weight] : axis.terms)
                if (speaksFrom(name, list, item))
                    return refused(name, trLater("an axis of a view"));
        for (const auto& [name, value] : scene.slice.origin)
            if (speaksFrom(name, list, item))
                return refused(name, trLater("a number of a view's slice"));
        for (const EnsembleRange& range : scene.ensemble.ranges)
            if (speaksFrom(range.name, list, item))
                return refused(range.name, trLater("drawn at random by an ensemble"));
    }
    for (const KeyFrame& key : workspace.motion.keys)
        for (const auto& [name, value] : key.values)
            if (speaksFrom(name, list, item)) return refused(name, trLater("part of the motion"));
    return {};
}

}  // namespace

bool hasRoots(const Workspace& workspace) { return !workspace.views[0].lists.empty(); }

bool isRoot(const Workspace& workspace, const RootRef& ref) {
    const auto found = workspace.views[0].lists.find(ref.list);
    return ref.item >= 0 && found != workspace.views[0].lists.end() &&
           at(ref.item) < found->second.roots.size();
}

const RootList::Root& rootAt(const Workspace& workspace, const RootRef& ref) {
    return workspace.views[0].lists.at(ref.list).roots[at(ref.item)];
}

double exponentOf(const Workspace& workspace, const RootRef& ref) {
    const double scale = workspace.views[0].lists.at(ref.list).scale;
    return rootAt(workspace, ref).power * scale *
           (isPoles(mapOf(workspace.views[0]).info, ref.list) ? -1 : 1);
}

std::array<double, 4> placeOfRoot(const Scene& scene, const RootList::Root& root) {
    std::array<double, 4> place = root.q;
    if (!mapOf(scene).info.field) return place;
    const std::array<double, 4> shift = shapeControls(scene).shift;
    for (std::size_t k = 0; k < place.size(); ++k) place[k] += shift[k];
    return place;
}

std::array<double, 4> rootOfPlace(const Scene& scene, const std::array<double, 4>& place) {
    const std::array<double, 4> shift = placeOfRoot(scene, {});
    std::array<double, 4> root = place;
    for (std::size_t k = 0; k < root.size(); ++k) root[k] -= shift[k];
    return root;
}

void setRoot(Workspace& workspace, const RootRef& ref, const RootList::Root& root) {
    for (Scene& scene : workspace.views) scene.lists.at(ref.list).roots[at(ref.item)] = root;
}

Expected<RootRef> addRoot(Workspace& workspace, const std::string& list,
                          const RootList::Root& root) {
    const std::size_t count = workspace.views[0].lists.at(list).roots.size();
    if (count >= kMostRoots)
        return Status::usage("a list has at most " + std::to_string(kMostRoots) + " roots");
    for (Scene& scene : workspace.views) scene.lists.at(list).roots.push_back(root);
    return RootRef{list, static_cast<int>(count)};
}

Status removeRoot(Workspace& workspace, const RootRef& ref) {
    if (Status status = mayLose(workspace, ref.list, ref.item); !status.ok()) return status;
    for (Scene& scene : workspace.views) {
        auto& roots = scene.lists.at(ref.list).roots;
        roots.erase(roots.begin() + ref.item);
    }
    return {};
}

Status setRootList(Workspace& workspace, const std::string& list, const RootList& roots) {
    if (Status status = mayLose(workspace, list, static_cast<int>(roots.roots.size()));
        !status.ok())
        return status;
    for (Scene& scene : workspace.views) scene.lists.at(list) = roots;
    return {};
}

Expected<RootRef> turnRoot(Workspace& workspace, const RootRef& ref) {
    RootList::Root root = rootAt(workspace, ref);
    const MapInfo& info = mapOf(workspace.views[0]).info;
    const bool poles = isPoles(info, ref.list);
    const auto other =
        std::find_if(info.lists.begin(), info.lists.end(),
                     [&](std::string_view list) { return isPoles(info, list) != poles; });
    if (other == info.lists.end()) {
        root.power = -root.power;
        setRoot(workspace, ref, root);
        return ref;
    }
    if (Status status = removeRoot(workspace, ref); !status.ok()) return status;
    return addRoot(workspace, std::string(*other), root);
}

std::string sumOrProductOf(const std::string& map) {
    const MapKernels* known = findMap(map);
    const MapKernels* other = known ? sumOrProductOf(known->info) : nullptr;
    return other ? std::string(other->info.name) : std::string();
}

bool isRootSum(const std::string& map) {
    const MapKernels* known = findMap(map);
    return known && known->info.rootForm == RootForm::sum;
}

void takeRootSum(Workspace& workspace, bool sum) {
    const std::string other = sumOrProductOf(workspace.views[0].map);
    if (other.empty() || isRootSum(workspace.views[0].map) == sum) return;
    // Both maps have the same parameters and lists.
    for (Scene& scene : workspace.views) scene.map = other;
}

std::string drawnList(const Workspace& workspace) {
    const auto& lists = mapOf(workspace.views[0]).info.lists;
    return lists.empty() ? std::string() : std::string(lists[0]);
}

Expected<RandomRoots> drawOptions(StudioContext& context) {
    RandomRoots options = context.versor.draw.options;
    const Scene& scene = context.workspace.views[context.workspace.speaker()];
    if (mapOf(scene).info.field) {
        const OrbitProgram* program = context.bound.orbitProgram();
        if (!program || !program->field)
            return Status::usage("the shape is not ready yet: its distances are being computed");
        takeShapeBox(scene, *program->field, options);
    } else if (mapOf(scene).info.algebra == Algebra::complex) {
        options.half[2] = options.half[3] = 0;
    }
    if (Status status = checkRandomRoots(options); !status.ok()) return status;
    return options;
}

void drawRoots(StudioContext& context, int seed) {
    const Expected<RandomRoots> options = drawOptions(context);
    if (!options) return context.report(options.status());
    context.versor.draw.seed = seed;
    const RootList roots = randomRoots(*options, static_cast<std::uint64_t>(seed));
    const Status status =
        context.edit([&](Workspace& w) { return setRootList(w, drawnList(w), roots); });
    if (!status.ok()) return context.report(status);
    context.versor.chosen = {};
    context.say(
        tr("{1} roots of seed {2}", {std::to_string(roots.roots.size()), std::to_string(seed)}));
}

}  // namespace versorium
