// SPDX-License-Identifier: MIT
// Formulas, shapes and outlines as they are typed, and values for --set.
#include <cstddef>
#include <string>

#include "io/document.h"
#include "maps/formula_map.h"
#include "scene/shape_name.h"
#include "shape/outline.h"
#include "shape/tree.h"

using namespace versorium;

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
    const std::string text(reinterpret_cast<const char*>(data), size);
    if (const auto formula = FormulaMap::make(text); formula) (void)sceneOfMap(text);
    const Expected<ShapeTree> shape = parseShape(text);
    if (!shape && shape.status().message().empty()) __builtin_trap();
    if (shape) (void)distance(*shape, 0.1, -0.2, 0.3);
    (void)isOutline(text);
    (void)parseOutline(text);
    (void)checkShapeText(text);
    return 0;
}
