// SPDX-License-Identifier: MIT
#include "ui/session/formulas.h"

#include <algorithm>

#include "base/text.h"
#include "scene/parts.h"
#include "ui/session/context.h"

namespace versorium {
namespace {

constexpr const char* kStored = "formulas";
constexpr const char* kFirst = "z^2 + c";

// What the old scene has and the new formula takes as well.
void keepWhatFits(Scene& scene, const Scene& old) {
    for (auto& [name, value] : scene.parameters) {
        const auto before = old.parameters.find(name);
        if (before != old.parameters.end() && before->second.size() == value.size())
            value = before->second;
    }
    if (mapOf(scene).info.field && mapOf(old).info.field) keepShape(scene, old);
    keepLook(scene, old);
    scene.samples = old.samples;
    scene.iterations = old.iterations;
}

bool axesFit(const Scene& scene, const SliceSpec& slice) {
    for (const SliceAxis& axis : slice.axes)
        for (const auto& [name, weight] : axis.terms)
            if (!numberNamed(scene, name)) return false;
    for (const auto& [name, value] : slice.origin)
        if (!numberNamed(scene, name)) return false;
    return true;
}

}  // namespace

void SavedFormulas::load(Host& host) {
    all_.clear();
    const Expected<Json> json = parseJson(host.stored(kStored));
    if (!json || !json->is_array()) return;
    for (const Json& entry : *json) {
        if (all_.size() == kMost) return;
        SavedFormula one;
        ObjectReader reader(entry, "formulas");
        reader.text("name", one.name).text("formula", one.text);
        if (!reader.finish().ok() || one.name.empty() || one.name.size() > kNameSize) continue;
        if (FormulaMap::make(one.text)) all_.push_back(std::move(one));
    }
}

void SavedFormulas::store(Host& host) const {
    Json json = Json::array();
    for (const SavedFormula& one : all_)
        json.push_back(Json{{"name", one.name}, {"formula", one.text}});
    host.store(kStored, json.dump(-1, ' ', true, Json::error_handler_t::replace));
}

Status SavedFormulas::save(Host& host, const std::string& given, const std::string& text) {
    const std::string name = trimmed(given);
    if (name.empty()) return Status::usage("type a name to save the formula under");
    if (name.size() > kNameSize)
        return Status::usage("the name is too long: at most " + std::to_string(kNameSize) +
                             " bytes");
    const auto found = std::find_if(all_.begin(), all_.end(),
                                    [&](const SavedFormula& one) { return one.name == name; });
    if (found != all_.end()) {
        found->text = text;
    } else {
        if (all_.size() == kMost)
            return Status::usage(std::to_string(kMost) +
                                 " formulas are saved already: forget one first");
        all_.push_back({name, text});
    }
    store(host);
    return {};
}

void SavedFormulas::forget(Host& host, const std::string& name) {
    std::erase_if(all_, [&](const SavedFormula& one) { return one.name == name; });
    store(host);
}

Status applyFormula(StudioContext& context, const std::string& text) {
    const auto map = FormulaMap::make(text);
    if (!map) return map.status();
    const Scene& first = context.workspace.views[0];
    if (first.formula == *map) return {};
    const Scene home = sceneOf((*map)->kernels());
    const Scene before = first;
    const MapInfo &now = (*map)->kernels().info, &old = mapOf(before).info;
    bool fits = before.formula && old.algebra == now.algebra && old.field == now.field;
    for (const Scene& view : context.workspace.views) fits = fits && axesFit(home, view.slice);
    if (fits) {
        // The same places, looked at with another formula.
        context.edit([&](Workspace& w) {
            for (Scene& view : w.views) {
                Scene scene = home;
                keepWhatFits(scene, view);
                scene.slice = view.slice;
                scene.start = view.start;
                scene.escapeRadius = view.escapeRadius;
                if (view.criticalStart && (*map)->kernels().stepSecond)
                    scene.criticalStart = view.criticalStart;
                view = std::move(scene);
            }
            w.pins.clear();
        });
        context.player.animation.running = false;
    } else {
        Scene scene = home;
        keepWhatFits(scene, before);
        scene.iterations = home.iterations;
        Workspace next = workspaceOf(scene);
        const int count = static_cast<int>(context.workspace.views.size());
        if (count != 2) setViewCount(next, count);
        context.open(std::move(next));
    }
    context.formula.text = context.formula.shown = (*map)->formula().text;
    context.formula.fault = {};
    return {};
}

void editFormula(StudioContext& context) {
    FormulaEditor& editor = context.formula;
    const Scene& scene = context.workspace.views[0];
    editor.open = true;
    editor.focusFrames = 30;
    editor.text = editor.shown = scene.formula ? scene.formula->formula().text : kFirst;
    editor.fault = {};
    context.host.wake();
}

std::optional<std::string> formulaIn(const std::string& text) {
    const std::string typed = trimmed(text);
    if (!looksLikeFormula(typed) || !FormulaMap::make(typed)) return {};
    return typed;
}

}  // namespace versorium
