// SPDX-License-Identifier: MIT
#pragma once
// How the list of controls (ui/controls/controls.h) is put together: each panel's file adds its own
// part to one ControlList, with what setting each control does.

#include <algorithm>
#include <array>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "ui/controls/controls.h"
#include "ui/session/studio_properties.h"
#include "ui/session/values.h"

namespace versorium {

// A control with what setting it does; that returns false where the value does not suit.
struct ControlEntry {
    Control control;
    std::function<bool(const std::string&)> set;
};

class ControlList {
  public:
    explicit ControlList(StudioContext& context) : context_(context) {}

    std::vector<ControlEntry> entries;
    // Groups and labels in English, or in the language where they are put together.
    void begin(const std::string& group) { group_ = tr(std::string_view(group)); }

    void number(const std::string& id, const std::string& label, double value, double step,
                double low, double high, std::function<void(double)> set,
                std::array<double, 2> slider = {}) {
        const auto change = [=](const std::string& text) {
            const std::optional<double> wanted = parseShownNumber(text);
            if (!wanted || !(*wanted >= low && *wanted <= high)) return false;
            set(*wanted);
            return true;
        };
        // A number of the map is called as its formula has it.
        const std::string shown = label == id ? label : said(label);
        Control control{id, group_, shown, ControlKind::number, formatNumber(value), step, {}};
        control.low = slider[0];
        control.high = slider[1];
        add(std::move(control), change);
    }
    // `shown` says the options in the language where they are no words, such as names.
    void choice(const std::string& id, const std::string& label, const std::string& value,
                const std::vector<std::string>& options,
                std::function<void(const std::string&)> set, std::vector<std::string> shown = {}) {
        const auto change = [=](const std::string& wanted) {
            if (std::find(options.begin(), options.end(), wanted) == options.end()) return false;
            if (wanted != value) set(wanted);
            return true;
        };
        if (shown.empty())
            for (const std::string& option : options) shown.push_back(tr(std::string_view(option)));
        add({id, group_, said(label), ControlKind::choice, value, 0, options, std::move(shown)},
            change);
    }
    void toggle(const std::string& id, const std::string& label, bool value,
                std::function<void(bool)> set) {
        const auto change = [=](const std::string& wanted) {
            if (wanted != "on" && wanted != "off") return false;
            set(wanted == "on");
            return true;
        };
        add({id, group_, said(label), ControlKind::toggle, value ? "on" : "off", 0, {}}, change);
    }
    void text(const std::string& id, const std::string& label, const std::string& value,
              std::function<bool(const std::string&)> set) {
        entries.push_back(
            {{id, group_, said(label), ControlKind::text, value, 0, {}}, std::move(set)});
    }
    // Commands touch the workspace themselves.
    void command(const std::string& id, const std::string& label, const std::string& keys,
                 std::function<void()> run) {
        const auto change = [run = std::move(run)](const std::string&) {
            run();
            return true;
        };
        entries.push_back({{id, group_, said(label), ControlKind::command, keys, 0, {}}, change});
    }

    // A value of the tables: of the focused view's scene, the workspace or the studio.
    void value(const SceneProperty& property);
    void value(const WorkspaceProperty& property);
    void value(const StudioProperty& property);
    // Those that apply and matter now, by their paths.
    void values(std::initializer_list<const char*> paths);
    // All of a group of the scene.
    void group(const std::string& path);

  private:
    StudioContext& context_;
    std::string group_;

    static std::string said(const std::string& label) { return tr(std::string_view(label)); }
    void add(Control control, std::function<bool(const std::string&)> set) {
        StudioContext* context = &context_;
        const auto change = [context, set = std::move(set)](const std::string& value) {
            if (!set(value)) return false;
            context->welcome = false;
            context->host.wake();
            return true;
        };
        entries.push_back({std::move(control), change});
    }
};

// The parts that have files of their own.
void collectShape(StudioContext& context, ControlList& all);
void collectVersor(StudioContext& context, ControlList& all);
void collectEnsemble(StudioContext& context, ControlList& all);
void collectLayers(StudioContext& context, ControlList& all);
void collectMotion(StudioContext& context, ControlList& all);
void collectWindow(StudioContext& context, ControlList& all);
void collectLessons(StudioContext& context, ControlList& all);
void collectCommands(StudioContext& context, ControlList& all);

}  // namespace versorium
