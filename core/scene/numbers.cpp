// SPDX-License-Identifier: MIT
#include "scene/numbers.h"

#include <cstdlib>

namespace versorium {
namespace {

std::optional<int> rootComponent(const MapInfo& info, const std::string& name) {
    if (name == "power") return 4;
    const bool complex = info.algebra == Algebra::complex;
    constexpr const char* kComplex[] = {"re", "im"};
    constexpr const char* kQuaternion[] = {"w", "x", "y", "z"};
    for (int k = 0; k < (complex ? 2 : 4); ++k)
        if (name == (complex ? kComplex : kQuaternion)[k]) return k;
    return std::nullopt;
}

std::optional<NumberRef> listNumber(const Scene& scene, const std::string& name) {
    const std::size_t open = name.find('['), close = name.find("].");
    if (open == std::string::npos || close == std::string::npos || close < open)
        return std::nullopt;
    NumberRef ref{NumberKind::list, 0, {}, 0, 0, 0};
    ref.list = name.substr(0, open);
    const auto found = scene.lists.find(ref.list);
    if (found == scene.lists.end()) return std::nullopt;
    const std::string digits = name.substr(open + 1, close - open - 1);
    if (digits.empty() || digits.size() > 5 ||
        digits.find_first_not_of("0123456789") != std::string::npos)
        return std::nullopt;
    ref.item = std::atoi(digits.c_str());
    if (static_cast<std::size_t>(ref.item) >= found->second.roots.size()) return std::nullopt;
    const MapInfo& info = mapOf(scene).info;
    const auto component = rootComponent(info, name.substr(close + 2));
    if (!component) return std::nullopt;
    ref.component = *component;
    for (std::size_t k = 0; k < info.lists.size(); ++k)
        if (info.lists[k] == ref.list) ref.listIndex = static_cast<int>(k);
    return ref;
}

// The parameter that holds the flat component, and the place inside of it.
std::pair<const ParameterInfo*, std::size_t> parameterAt(const Scene& scene, int index) {
    for (const ParameterInfo& parameter : mapOf(scene).info.parameters) {
        if (index < widthOf(parameter.kind)) return {&parameter, static_cast<std::size_t>(index)};
        index -= widthOf(parameter.kind);
    }
    assert(false);
    return {};
}

}  // namespace

std::optional<NumberRef> numberNamed(const Scene& scene, const std::string& name) {
    const MapKernels& map = mapOf(scene);
    for (int k = 0; k < map.dimension; ++k)
        if (stateComponent(map.info, k) == name)
            return NumberRef{NumberKind::state, k, {}, 0, 0, 0};
    for (int k = 0; k < map.parameters; ++k)
        if (parameterComponent(map.info, k) == name)
            return NumberRef{NumberKind::parameter, k, {}, 0, 0, 0};
    return listNumber(scene, name);
}

double numberValue(const Scene& scene, const NumberRef& number) {
    if (number.kind == NumberKind::state)
        return scene.start[static_cast<std::size_t>(number.index)];
    if (number.kind == NumberKind::parameter) {
        const auto [parameter, at] = parameterAt(scene, number.index);
        return scene.parameters.at(std::string(parameter->name))[at];
    }
    const RootList::Root& root =
        scene.lists.at(number.list).roots[static_cast<std::size_t>(number.item)];
    return number.component == 4 ? root.power : root.q[static_cast<std::size_t>(number.component)];
}

void setNumber(Scene& scene, const NumberRef& number, double value) {
    if (number.kind == NumberKind::state) {
        scene.start[static_cast<std::size_t>(number.index)] = value;
    } else if (number.kind == NumberKind::parameter) {
        const auto [parameter, at] = parameterAt(scene, number.index);
        scene.parameters.at(std::string(parameter->name))[at] = value;
    } else {
        RootList::Root& root =
            scene.lists.at(number.list).roots[static_cast<std::size_t>(number.item)];
        (number.component == 4 ? root.power : root.q[static_cast<std::size_t>(number.component)]) =
            value;
    }
}

bool isOfView(const Scene& scene, const NumberRef& number) {
    return number.kind == NumberKind::parameter && parameterAt(scene, number.index).first->ofView;
}

bool isOnAxis(const SliceSpec& slice, const std::string& name) {
    for (const SliceAxis& axis : slice.axes)
        for (const auto& [term, weight] : axis.terms)
            if (term == name) return true;
    return false;
}

std::string numberNames(const Scene& scene) {
    const MapKernels& map = mapOf(scene);
    std::string all;
    for (int k = 0; k < map.dimension; ++k)
        all += (k > 0 ? ", " : "") + stateComponent(map.info, k);
    for (int k = 0; k < map.parameters; ++k) all += ", " + parameterComponent(map.info, k);
    for (const auto& [name, list] : scene.lists)
        if (!list.roots.empty())
            all += ", " + name + "[0…" + std::to_string(list.roots.size() - 1) + "]." +
                   (map.info.algebra == Algebra::complex ? "re|im|power" : "w|x|y|z|power");
    return all;
}

}  // namespace versorium
