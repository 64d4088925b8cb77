// SPDX-License-Identifier: MIT
#pragma once
// Everything that can be set or done in the studio, as a list of values: for hands and ears that
// the panels do not reach. A page makes controls of its own from it, which the keyboard walks and a
// screen reader speaks.

#include <string>
#include <vector>

#include "ui/session/context.h"

namespace versorium {

enum class ControlKind { number, choice, toggle, colour, text, command };

struct Control {
    std::string id;            // stays the same while the map does
    std::string group, label;  // in the language
    ControlKind kind = ControlKind::command;
    // What it is now: a number, one of the options, "on" or "off", "#rrggbb", a text; the keys
    // of a command.
    std::string value;
    double step = 0;  // of a number, for one stroke of a key
    std::vector<std::string> options;
    std::vector<std::string> shown = {};  // the options in the language
    double low = 0, high = 0;             // of a number's slider; equal where there is none
    bool locked = false;  // by the link that opened the studio (ui/controls/access.h)
};

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
