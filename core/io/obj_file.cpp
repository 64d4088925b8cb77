// SPDX-License-Identifier: MIT
// Wavefront OBJ: lines "v x y z" and "f a b c …", where a corner is v, v/t, v//n or v/t/n, counted
// from 1, or backwards from the latest vertex when negative. A line that ends in a backslash goes
// on in the next one. All other lines are skipped.
#include <cstdint>

#include "geometry/triangulate.h"
#include "io/mesh_files.h"
#include "io/mesh_parts.h"
#include "io/text_scanner.h"

namespace versorium {
namespace {

Status fault(const TextScanner& scanner, const std::string& what) {
    return Status::data("line " + std::to_string(scanner.lineNumber()) +
                        " of the OBJ file: " + what);
}

Status readVertex(TextScanner& scanner, Mesh& mesh) {
    if (mesh.vertices.size() >= kMeshVertices) return fault(scanner, "too many vertices");
    glm::dvec3 vertex{};
    for (int axis = 0; axis < 3; ++axis) {
        const std::string_view word = scanner.word();
        const std::optional<double> value = parseDecimal(word);
        if (!value) return fault(scanner, "a coordinate is expected: " + numberFault(word));
        vertex[axis] = *value;
    }
    mesh.vertices.push_back(vertex);
    return {};
}

// Texture and normal indices after the first slash are not needed and not looked at.
Status readFace(TextScanner& scanner, std::vector<std::uint32_t>& corners, Mesh& mesh) {
    corners.clear();
    for (std::string_view word = scanner.word(); !word.empty(); word = scanner.word()) {
        if (word[0] == '#') break;
        const std::optional<std::int64_t> index = parseInteger(word.substr(0, word.find('/')));
        const auto count = static_cast<std::int64_t>(mesh.vertices.size());
        // A face may only use vertices that stand before it.
        if (!index || *index == 0 || *index > count || *index < -count)
            return fault(scanner, "the face's corner " + shownWord(word) + " is none of the " +
                                      std::to_string(count) + " vertices before it");
        corners.push_back(static_cast<std::uint32_t>(*index > 0 ? *index - 1 : count + *index));
    }
    if (corners.size() < 3) return fault(scanner, "a face needs at least three corners");
    if (mesh.triangles.size() + corners.size() > kMeshTriangles)
        return fault(scanner, "too many triangles");
    appendPolygon(corners, mesh);
    return {};
}

}  // namespace

bool isObj(std::span<const unsigned char> bytes) {
    constexpr std::size_t kLooked = 1 << 16;
    TextScanner scanner(textOf(bytes).substr(0, kLooked), {.continued = true});
    while (scanner.nextLine()) {
        const std::string_view key = scanner.word();
        if (key.find('\0') != std::string_view::npos) return false;
        if (key != "v") continue;
        bool numbers = true;
        for (int axis = 0; axis < 3; ++axis) numbers = numbers && parseReal(scanner.word());
        if (numbers) return true;
    }
    return false;
}

Expected<Mesh> readObj(std::span<const unsigned char> bytes) {
    Mesh mesh;
    TextScanner scanner(textOf(bytes), {.continued = true});
    std::vector<std::uint32_t> corners;
    while (scanner.nextLine()) {
        const std::string_view key = scanner.word();
        Status status;
        if (key == "v") status = readVertex(scanner, mesh);
        if (key == "f") status = readFace(scanner, corners, mesh);
        if (!status.ok()) return status;
    }
    if (const Status status = finishMesh(mesh, "OBJ"); !status.ok()) return status;
    return mesh;
}

}  // namespace versorium
