// SPDX-License-Identifier: MIT
#pragma once
// Closed meshes made from closed forms, for tests of readers and of distances.

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "geometry/mesh.h"

namespace versorium {

// An icosahedron whose triangles are cut in four `levels` times, its corners on the sphere.
inline Mesh icosphere(int levels, double radius = 1.0) {
    const double golden = (1 + std::sqrt(5.0)) / 2;
    Mesh mesh;
    for (double a : {-1.0, 1.0})
        for (double b : {-golden, golden}) {
            mesh.vertices.push_back({0, a, b});
            mesh.vertices.push_back({a, b, 0});
            mesh.vertices.push_back({b, 0, a});
        }
    // The faces are the triples of corners that are 2 apart from each other.
    const auto near = [&](std::size_t a, std::size_t b) {
        const glm::dvec3 d = mesh.vertices[a] - mesh.vertices[b];
        return std::abs(d.x * d.x + d.y * d.y + d.z * d.z - 4) < 1e-9;
    };
    for (std::uint32_t a = 0; a < 12; ++a)
        for (std::uint32_t b = a + 1; b < 12; ++b)
            for (std::uint32_t c = b + 1; c < 12; ++c) {
                if (!near(a, b) || !near(b, c) || !near(a, c)) continue;
                const glm::dvec3 u = mesh.vertices[a], v = mesh.vertices[b], w = mesh.vertices[c];
                const double side = u.x * (v.y * w.z - v.z * w.y) + u.y * (v.z * w.x - v.x * w.z) +
                                    u.z * (v.x * w.y - v.y * w.x);
                if (side > 0) {
                    mesh.triangles.push_back({a, b, c});
                } else {
                    mesh.triangles.push_back({a, c, b});
                }
            }
    for (int level = 0; level < levels; ++level) {
        std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
        const auto middle = [&](std::uint32_t a, std::uint32_t b) {
            const auto key = std::minmax(a, b);
            const auto found = middles.find(key);
            if (found != middles.end()) return found->second;
            const auto index = static_cast<std::uint32_t>(mesh.vertices.size());
            mesh.vertices.push_back((mesh.vertices[a] + mesh.vertices[b]) / 2.0);
            middles[key] = index;
            return index;
        };
        Mesh finer = mesh;
        finer.triangles.clear();
        for (const auto& t : mesh.triangles) {
            const std::uint32_t ab = middle(t[0], t[1]), bc = middle(t[1], t[2]),
                                ca = middle(t[2], t[0]);
            finer.triangles.push_back({t[0], ab, ca});
            finer.triangles.push_back({ab, t[1], bc});
            finer.triangles.push_back({ca, bc, t[2]});
            finer.triangles.push_back({ab, bc, ca});
        }
        finer.vertices = mesh.vertices;
        mesh = std::move(finer);
    }
    for (glm::dvec3& v : mesh.vertices) v *= radius / std::sqrt(v.x * v.x + v.y * v.y + v.z * v.z);
    return mesh;
}

// A torus about the z axis with corners on its surface.
inline Mesh torusMesh(double large, double small, int around, int across) {
    Mesh mesh;
    for (int i = 0; i < around; ++i)
        for (int j = 0; j < across; ++j) {
            const double a = 2 * M_PI * i / around, b = 2 * M_PI * j / across;
            const double r = large + small * std::cos(b);
            mesh.vertices.push_back({r * std::cos(a), r * std::sin(a), small * std::sin(b)});
        }
    const auto at = [&](int i, int j) {
        return static_cast<std::uint32_t>(i % around * across + j % across);
    };
    for (int i = 0; i < around; ++i)
        for (int j = 0; j < across; ++j) {
            mesh.triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
            mesh.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
        }
    return mesh;
}

}  // namespace versorium
