// SPDX-License-Identifier: MIT
#pragma once
// Whether the critical point that a scene starts from is there.

#include "fields/evaluate.h"
#include "scene/scene.h"

namespace versorium {

// ErrorKind::data where none of nine places of the picture has that critical point. The program is
// bound.
Status checkCriticalStart(const Scene& scene, const OrbitProgram& program);

}  // namespace versorium
