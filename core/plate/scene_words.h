// SPDX-License-Identifier: MIT
#pragma once
// A scene in words, for axes, captions and alternative texts. Names of numbers become markup
// (plate/markup.h); texts and numbers are in the language of the words given.

#include <map>
#include <string>

#include "fields/evaluate.h"
#include "i18n/language.h"
#include "scene/scene.h"

namespace versorium {

// With six digits and a true minus sign.
std::string plateNumber(double value, const Words& words);

// "z.re" -> "Re z", "g.b1" -> "b_{1}^{g}", "q.w" -> "w", "roots[2].re" -> "Re roots_{2}".
std::string axisText(const std::string& name, const Words& words);
// A sum of them, with weights other than 1.
std::string axisText(const SliceAxis& axis, const Words& words);

// What captions may name: {"alpha": "6"}.
std::map<std::string, std::string> sceneFacts(const Scene& scene, const OrbitProgram& program,
                                              const Words& words);
// A sentence about the picture, plain text: map, parameters, plane, rule of colour.
std::string sceneSentence(const Scene& scene, const Words& words);

}  // namespace versorium
