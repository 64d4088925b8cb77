// SPDX-License-Identifier: MIT
#pragma once
// A step of a lesson as a figure plate: what the views show, with the step's text below.

#include "lesson/lesson.h"
#include "plate/plate_picture.h"

namespace versorium {

PlateDocument plateOfStep(const Lesson& lesson, std::size_t step);
// The same of another state, such as a learner's: the plate to take home.
PlateDocument plateOfStep(const Lesson& lesson, std::size_t step, const Workspace& shown);

}  // namespace versorium
