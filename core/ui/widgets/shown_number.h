// SPDX-License-Identifier: MIT
#pragma once
// A field of a number that is dragged or typed, in the language's form: where numbers have a comma
// it is shown and kept while one types, and a typed point or comma is taken in every language.

namespace versorium {

// ImGui::DragScalar for a double. `format` is printf's, with text around the number at will; `low`
// and `high` bound the value where low < high. True when it changed; it stays finite.
bool dragNumber(const char* label, double& value, double speed, const char* format, double low = 0,
                double high = 0);

}  // namespace versorium
