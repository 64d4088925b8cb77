// SPDX-License-Identifier: MIT
#pragma once
// What there is of a view, drawn: the picture as far as it has come, the marks, the title, what
// went wrong, the line of progress and the border of the focused view.

#include "ui/marks/view_frame.h"

namespace versorium {

void drawViewParts(const ViewFrame& frame);

}  // namespace versorium
