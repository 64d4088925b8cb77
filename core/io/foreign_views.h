// SPDX-License-Identifier: MIT
#pragma once
// Views of other programs as scenes, as far as their map is one of ours: XaoS (.xpf), Fractint and
// Iterated Dynamics (.par), Kalles Fraktaler (.kfr). Place, size, iterations and parameters are
// taken; colours are not.

#include <span>
#include <string>

#include "scene/scene.h"

namespace versorium {

struct ForeignView {
    Scene scene;
    std::string note;  // what was left out, as a sentence
};

bool looksLikeForeignView(std::span<const unsigned char> bytes);

// Fails with ErrorKind::data, and with the name of a map that has no counterpart here.
Expected<ForeignView> readForeignView(std::span<const unsigned char> bytes);

}  // namespace versorium
