// SPDX-License-Identifier: MIT
#pragma once
// A number of the inspector: a slider through its range, a field to drag or to type in, and a menu
// with the range, the exact value and the animation.

#include <optional>
#include <string>
#include <string_view>

#include "ui/session/context.h"

namespace versorium {

struct NumberLook {
    std::string_view help = {};       // of the number itself
    double low = -2, high = 2;        // the range, unless the user gave it another
    std::optional<double> home = {};  // what reset brings back
    bool whole = false;
    bool slider = true;
    bool animated = false;     // a number of the workspace by the same name
    bool logarithmic = false;  // the slider; needs low > 0
};

// The label, in English or in the language already, stands on the left. `name` is the key of its
// range. True when the value changed; it is
// always finite, but may lie beyond the range.
bool numberField(StudioContext& context, const std::string& name, const std::string& label,
                 double& value, const NumberLook& look);

// The same in as little room as a table's cell: a field to drag or to type in, with the menu behind
// the button beside it. `width` of both together.
bool numberCell(StudioContext& context, const std::string& name, double& value,
                const NumberLook& look, float width);

}  // namespace versorium
