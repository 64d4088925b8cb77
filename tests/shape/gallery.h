// SPDX-License-Identifier: MIT
#pragma once
// One example of every shape that stands alone; the solids lie within the box [-½, ½]³, the shapes
// of the plane within [-½, ½]².

#include <span>

namespace versorium {

struct NamedShape {
    const char* name;
    const char* text;
};

inline std::span<const NamedShape> shapeGallery() {
    static constexpr NamedShape kGallery[] = {
        {"disc", "disc(0.4)"},
        {"sphere", "sphere(0.4)"},
        {"box", "box(0.35, 0.3, 0.25)"},
        {"torus", "torus(0.28, 0.12)"},
        {"capsule", "capsule(0.2, 0.2)"},
        {"star", "star(5, 0.45, 0.18)"},
        {"heart", "heart(0.8)"},
        {"crescent", "crescent(0.42, 0.36, 0.2)"},
    };
    return kGallery;
}

}  // namespace versorium
