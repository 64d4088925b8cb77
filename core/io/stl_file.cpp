// SPDX-License-Identifier: MIT
// STL. Binary: 80 bytes, uint32 count, and for each triangle a normal, three corners (12 float32)
// and two spare bytes. ASCII: "vertex x y z" three times in each facet, in letters of any case.
// Normals are not used, and bytes after the last triangle of a binary file neither.
#include <cmath>
#include <cstdint>
#include <unordered_map>

#include "io/byte_reader.h"
#include "io/mesh_files.h"
#include "io/mesh_parts.h"
#include "io/text_scanner.h"

namespace versorium {
namespace {

constexpr std::size_t kHeader = 84, kFacet = 50;

struct PositionHash {
    std::size_t operator()(const glm::dvec3& point) const {
        std::uint64_t hash = 0x9e3779b97f4a7c15ULL;
        for (int axis = 0; axis < 3; ++axis) {
            std::uint64_t bits;
            std::memcpy(&bits, &point[axis], sizeof bits);
            hash = (hash ^ bits) * 0xbf58476d1ce4e5b9ULL;
            hash ^= hash >> 29;
        }
        return static_cast<std::size_t>(hash);
    }
};

// Gives corners with the same coordinates the same index. The map is never walked through, so its
// order does not matter.
class Welder {
  public:
    explicit Welder(Mesh& mesh) : mesh_(mesh) {}

    std::uint32_t indexOf(glm::dvec3 point) {
        point += 0.0;  // turns -0 into 0, which are one place
        const auto next = static_cast<std::uint32_t>(mesh_.vertices.size());
        const auto [entry, isNew] = indices_.try_emplace(point, next);
        if (isNew) mesh_.vertices.push_back(point);
        return entry->second;
    }

  private:
    Mesh& mesh_;
    std::unordered_map<glm::dvec3, std::uint32_t, PositionHash> indices_;
};

std::uint32_t claimedCount(std::span<const unsigned char> bytes) {
    ByteReader reader(bytes);
    reader.skip(80);
    return reader.read<std::uint32_t>();
}

Expected<Mesh> readBinary(std::span<const unsigned char> bytes) {
    if (bytes.size() < kHeader)
        return Status::data("the STL file has " + std::to_string(bytes.size()) +
                            " bytes, fewer than its header");
    const std::size_t count = claimedCount(bytes);
    if (count > (bytes.size() - kHeader) / kFacet || count > kMeshTriangles)
        return Status::data("the STL file claims " + std::to_string(count) +
                            " triangles, but its length has room for " +
                            std::to_string((bytes.size() - kHeader) / kFacet) +
                            "; it is cut short or no STL");
    Mesh mesh;
    mesh.triangles.reserve(count);
    Welder welder(mesh);
    ByteReader reader(bytes);
    reader.skip(kHeader);
    for (std::size_t i = 0; i < count; ++i) {
        reader.skip(12);
        std::array<std::uint32_t, 3> triangle{};
        for (std::uint32_t& corner : triangle) {
            glm::dvec3 point;
            for (int axis = 0; axis < 3; ++axis) point[axis] = reader.read<float>();
            if (!std::isfinite(point.x) || !std::isfinite(point.y) || !std::isfinite(point.z))
                return Status::data("triangle " + std::to_string(i + 1) +
                                    " of the STL file has a coordinate that is not finite");
            corner = welder.indexOf(point);
        }
        reader.skip(2);
        mesh.triangles.push_back(triangle);
    }
    if (const Status status = finishMesh(mesh, "STL"); !status.ok()) return status;
    return mesh;
}

std::string whereIn(const TextScanner& scanner) {
    return "line " + std::to_string(scanner.lineNumber()) + " of the STL file: ";
}

Expected<glm::dvec3> readCorner(TextScanner& scanner) {
    glm::dvec3 point;
    for (int axis = 0; axis < 3; ++axis) {
        const std::string_view word = scanner.wordAcrossLines();
        const std::optional<double> value = parseDecimal(word);
        if (!value)
            return Status::data(whereIn(scanner) +
                                "a coordinate is expected: " + numberFault(word));
        point[axis] = *value;
    }
    return point;
}

// Words, whatever their case and lines. A solid's name is passed over up to the end of its line.
Expected<Mesh> readAscii(std::span<const unsigned char> bytes) {
    Mesh mesh;
    Welder welder(mesh);
    TextScanner scanner(textOf(bytes));
    std::array<std::uint32_t, 3> triangle{};
    std::size_t corners = 0;
    while (true) {
        const std::string_view word = scanner.wordAcrossLines();
        if (word.empty()) break;
        const std::string key = lowered(word.substr(0, 16));
        if (key == "endfacet") {
            if (corners != 3)
                return Status::data(whereIn(scanner) + "the facet has " + std::to_string(corners) +
                                    " corners, not 3");
            corners = 0;
            mesh.triangles.push_back(triangle);
        }
        if ((key == "solid" || key == "endsolid") &&
            lowered(scanner.rest()).find("facet ") == std::string::npos)
            scanner.skipRest();
        if (key != "vertex") continue;
        if (corners == 3)
            return Status::data(whereIn(scanner) + "a facet has more than three corners");
        const Expected<glm::dvec3> point = readCorner(scanner);
        if (!point) return point.status();
        if (mesh.triangles.size() >= kMeshTriangles)
            return Status::data(whereIn(scanner) + "too many triangles");
        triangle[corners++] = welder.indexOf(*point);
    }
    if (corners != 0) return Status::data("the STL file ends within a facet");
    if (const Status status = finishMesh(mesh, "STL"); !status.ok()) return status;
    return mesh;
}

// No binary file: what stands where its count should be does not fit the bytes.
bool claimedTooMuch(std::span<const unsigned char> bytes) {
    return bytes.size() < kHeader || claimedCount(bytes) > (bytes.size() - kHeader) / kFacet;
}

}  // namespace

bool isBinaryStl(std::span<const unsigned char> bytes) {
    return bytes.size() >= kHeader && (bytes.size() - kHeader) % kFacet == 0 &&
           (bytes.size() - kHeader) / kFacet == claimedCount(bytes);
}

bool isTextStl(std::span<const unsigned char> bytes) {
    if (isBinaryStl(bytes)) return false;
    TextScanner scanner(textOf(bytes));
    const std::string first = lowered(scanner.wordAcrossLines().substr(0, 16));
    if (first == "facet") return true;
    if (first != "solid") return false;
    // Some programs begin a binary file with this word too; its count of triangles has a zero byte
    // where a text has none, and a text goes on with a facet or ends.
    const std::string text = lowered(textOf(bytes).substr(0, 4096));
    if (text.find('\0') != std::string::npos) return false;
    return text.find("facet") != std::string::npos || text.find("vertex") != std::string::npos ||
           text.find("endsolid") != std::string::npos || claimedTooMuch(bytes);
}

Expected<Mesh> readStl(std::span<const unsigned char> bytes) {
    return isTextStl(bytes) ? readAscii(bytes) : readBinary(bytes);
}

}  // namespace versorium
