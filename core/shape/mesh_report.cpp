// SPDX-License-Identifier: MIT
#include "shape/mesh_report.h"

#include <algorithm>
#include <array>
#include <glm/geometric.hpp>
#include <string_view>

#include "shape/mesh_field.h"

namespace versorium {
namespace {

struct MeshSide {
    std::uint32_t low, high;
    int direction;  // 1 or -1
};

void countSides(const std::vector<std::array<std::uint32_t, 3>>& triangles, MeshReport& report) {
    std::vector<MeshSide> sides;
    sides.reserve(3 * triangles.size());
    for (const auto& t : triangles)
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint32_t a = t[k], b = t[(k + 1) % 3];
            if (a != b) sides.push_back({std::min(a, b), std::max(a, b), a < b ? 1 : -1});
        }
    std::sort(sides.begin(), sides.end(), [](const MeshSide& a, const MeshSide& b) {
        return a.low != b.low ? a.low < b.low : a.high < b.high;
    });
    for (std::size_t i = 0; i < sides.size();) {
        const MeshSide first = sides[i];
        std::size_t count = 0;
        int net = 0;
        for (; i < sides.size() && sides[i].low == first.low && sides[i].high == first.high; ++i) {
            net += sides[i].direction;
            ++count;
        }
        if (count % 2 != 0)
            ++report.openSides;
        else if (net != 0)
            ++report.turnedSides;
    }
}

std::string counted(std::size_t count, std::string_view one, std::string_view many) {
    return std::to_string(count) + " " + std::string(count == 1 ? one : many);
}

}  // namespace

MeshReport reportOf(const Mesh& mesh) {
    MeshReport report;
    const std::vector<std::uint32_t> welded = weldedIndices(mesh);
    std::vector<std::array<std::uint32_t, 3>> triangles, sorted;
    triangles.reserve(mesh.triangles.size());
    double volume = 0;
    for (const auto& t : mesh.triangles) {
        const glm::dvec3 origin = mesh.vertices[mesh.triangles[0][0]];
        const glm::dvec3 a = mesh.vertices[t[0]] - origin, b = mesh.vertices[t[1]] - origin,
                         c = mesh.vertices[t[2]] - origin;
        const glm::dvec3 area = glm::cross(b - a, c - a);
        volume += glm::dot(a, glm::cross(b, c));
        triangles.push_back({welded[t[0]], welded[t[1]], welded[t[2]]});
        if (!(glm::dot(area, area) > 0)) {
            ++report.emptyTriangles;
            continue;
        }
        sorted.push_back(triangles.back());
        std::sort(sorted.back().begin(), sorted.back().end());
    }
    countSides(triangles, report);
    std::sort(sorted.begin(), sorted.end());
    for (std::size_t i = 1; i < sorted.size(); ++i)
        if (sorted[i] == sorted[i - 1]) ++report.doubledTriangles;
    report.turned = volume < 0;
    return report;
}

std::vector<std::string> warningsOf(const MeshReport& report) {
    std::vector<std::string> texts;
    if (report.openSides > 0)
        texts.push_back("the mesh is open: " + counted(report.openSides, "side has", "sides have") +
                        " no partner; inside is what the surface surrounds more than half");
    if (report.turnedSides > 0)
        texts.push_back("some faces of the mesh are turned: " +
                        counted(report.turnedSides, "side is", "sides are") +
                        " run through in one direction only; make its normals consistent in a "
                        "mesh program");
    if (report.doubledTriangles > 0)
        texts.push_back(counted(report.doubledTriangles, "triangle stands", "triangles stand") +
                        " twice in the mesh");
    if (report.emptyTriangles > 0)
        texts.push_back(counted(report.emptyTriangles, "triangle", "triangles") +
                        " without area in the mesh; they are left out");
    if (report.turned) texts.push_back("the mesh has its inside out; it was turned");
    return texts;
}

}  // namespace versorium
