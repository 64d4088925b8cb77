// SPDX-License-Identifier: MIT
#pragma once
// Everything that can be set or done in the studio, as a list of values: for hands and ears that
// the panels do not reach. A page makes controls of its own from it, which the keyboard walks and a
// screen reader speaks.

#include <optional>
#include <string>
#include <vector>

#include "ui/session/context.h"

namespace versorium {

enum class ControlKind { number, choice, toggle, colour, text, command };

struct Control {
    std::string id;            // a value's path; stays the same in every language
    std::string group, label;  // in the language
    ControlKind kind = ControlKind::command;
    // What it is now: a number, one of the options, "on" or "off", "#rrggbb", a text; the keys
    // of a command.
    std::string value;
    double step = 0;  // of a number, for one stroke of a key
    std::vector<std::string> options;
    std::vector<std::string> shown = {};  // the options in the language
    double low = 0, high = 0;             // of a number's slider; equal where there is none
    std::string name = {};                // the label without what the value is a part of
    std::string help = {};
    std::optional<double> home = {};      // what reset brings back
    double least = -1e300, most = 1e300;  // that a number may be
    bool whole = false, logarithmic = false, moves = false;
    bool locked = false;  // by the link that opened the studio (ui/controls/access.h)
};

// One value of the focused view's scene or of the workspace, by its path; nothing where it does not
// apply, does not matter now, or is hidden by a teacher's link.
std::optional<Control> controlOf(StudioContext& context, const std::string& path);
// Those of a group of the scene ("colour") that matter now.
std::vector<Control> controlsIn(StudioContext& context, const std::string& group);
// Without those that a teacher's link hides.
std::vector<Control> controlsOf(StudioContext& context);
// Sets a control, or does its command. False where there is none, where it is locked, or where it
// does not take this.
bool setControl(StudioContext& context, const std::string& id, const std::string& value);

// What a view shows, in a sentence.
std::string describeView(StudioContext& context, int view);

// All of it for a page, as JSON: {"controls": […], "views": [{"text", "low", "high"}], "focused",
// "language", "decimal"}. Values are the same in every language, numbers among them with a point.
// A view that is not shown has no rectangle.
std::string controlsText(StudioContext& context);

}  // namespace versorium
