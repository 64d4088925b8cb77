// SPDX-License-Identifier: MIT
// PLY (Turk 1994): a text header that lists elements and their properties, then the data as text
// or in binary of either byte order. Positions are the properties x, y, z of "vertex", faces the
// list "vertex_indices" or "vertex_index" of "face" or of "tristrips", whose strips of triangles
// end at -1; everything else is stepped over. The header's words may have letters of any case.
#include <cmath>
#include <cstdint>

#include "geometry/triangulate.h"
#include "io/byte_reader.h"
#include "io/mesh_files.h"
#include "io/mesh_parts.h"
#include "io/text_scanner.h"

namespace versorium {
namespace {

enum class Type { int8, uint8, int16, uint16, int32, uint32, float32, float64, none };

struct Property {
    std::string name;
    Type type = Type::none;
    Type countType = Type::none;  // of a list
    bool isList() const { return countType != Type::none; }
};

struct Element {
    std::string name;
    std::size_t count = 0;
    std::vector<Property> properties;
};

enum class Encoding { ascii, little, big };

struct PlyHeader {
    Encoding encoding = Encoding::ascii;
    std::vector<Element> elements;
    std::size_t dataOffset = 0;
};

constexpr std::size_t kElements = 64, kProperties = 256;

Type typeOf(std::string_view word) {
    struct Name {
        const char* name;
        Type type;
    };
    static constexpr Name kNames[] = {
        {"char", Type::int8},      {"int8", Type::int8},       {"uchar", Type::uint8},
        {"uint8", Type::uint8},    {"short", Type::int16},     {"int16", Type::int16},
        {"ushort", Type::uint16},  {"uint16", Type::uint16},   {"int", Type::int32},
        {"int32", Type::int32},    {"uint", Type::uint32},     {"uint32", Type::uint32},
        {"float", Type::float32},  {"float32", Type::float32}, {"double", Type::float64},
        {"float64", Type::float64}};
    for (const Name& entry : kNames)
        if (word == entry.name) return entry.type;
    return Type::none;
}

std::size_t sizeOf(Type type) {
    switch (type) {
        case Type::int8:
        case Type::uint8:
            return 1;
        case Type::int16:
        case Type::uint16:
            return 2;
        case Type::float64:
            return 8;
        default:
            return 4;
    }
}

// The numbers of the data, one after the other, in any encoding.
class NumberSource {
  public:
    NumberSource(std::span<const unsigned char> bytes, Encoding encoding)
        : encoding_(encoding), binary_(bytes, encoding == Encoding::big), text_(textOf(bytes)) {}

    double next(Type type) {
        if (encoding_ == Encoding::ascii) return nextDecimal();
        switch (type) {
            case Type::int8:
                return binary_.read<std::int8_t>();
            case Type::uint8:
                return binary_.read<std::uint8_t>();
            case Type::int16:
                return binary_.read<std::int16_t>();
            case Type::uint16:
                return binary_.read<std::uint16_t>();
            case Type::int32:
                return binary_.read<std::int32_t>();
            case Type::uint32:
                return binary_.read<std::uint32_t>();
            case Type::float32:
                return binary_.read<float>();
            default:
                return binary_.read<double>();
        }
    }
    bool failed() const { return failed_ || binary_.failed(); }
    // How many numbers of the type there can be at most in what is left; a number of text takes
    // its digit and a separator, the last one the digit alone.
    std::size_t room(Type type) const {
        return encoding_ == Encoding::ascii ? text_.remaining() / 2 + 1
                                            : binary_.remaining() / sizeOf(type);
    }

  private:
    double nextDecimal() {
        // What is not finite is a number all the same: it may stand where nobody looks.
        const std::optional<double> value = parseReal(text_.wordAcrossLines());
        failed_ = failed_ || !value;
        return value.value_or(0.0);
    }

    Encoding encoding_;
    ByteReader binary_;
    TextScanner text_;
    bool failed_ = false;
};

Status headerFault(const TextScanner& scanner, const std::string& what) {
    return Status::data("line " + std::to_string(scanner.lineNumber()) +
                        " of the PLY header: " + what);
}

Status readProperty(TextScanner& scanner, PlyHeader& header) {
    if (header.elements.empty()) return headerFault(scanner, "a property before any element");
    std::vector<Property>& properties = header.elements.back().properties;
    if (properties.size() >= kProperties) return headerFault(scanner, "too many properties");
    Property property;
    std::string word = lowered(scanner.word());
    if (word == "list") {
        property.countType = typeOf(lowered(scanner.word()));
        if (property.countType == Type::none || property.countType == Type::float32 ||
            property.countType == Type::float64)
            return headerFault(scanner, "the count of a list must be of an integer type");
        word = lowered(scanner.word());
    }
    property.type = typeOf(word);
    if (property.type == Type::none) return headerFault(scanner, "an unknown type of number");
    property.name = lowered(scanner.word());
    properties.push_back(property);
    return {};
}

Status readElement(TextScanner& scanner, PlyHeader& header) {
    if (header.elements.size() >= kElements) return headerFault(scanner, "too many elements");
    Element element;
    element.name = lowered(scanner.word());
    const std::optional<std::int64_t> count = parseInteger(scanner.word());
    if (!count || *count < 0)
        return headerFault(scanner, "the number of elements is not a whole number below 10^18");
    element.count = static_cast<std::size_t>(*count);
    if (static_cast<std::int64_t>(element.count) != *count)
        return headerFault(scanner, "the number of elements is larger than memory");
    header.elements.push_back(element);
    return {};
}

Status readFormat(TextScanner& scanner, PlyHeader& header) {
    const std::string word = lowered(scanner.word());
    if (word == "ascii") {
        header.encoding = Encoding::ascii;
    } else if (word == "binary_little_endian") {
        header.encoding = Encoding::little;
    } else if (word == "binary_big_endian") {
        header.encoding = Encoding::big;
    } else {
        return headerFault(scanner,
                           "an unknown format; ascii, binary_little_endian and "
                           "binary_big_endian can be read");
    }
    return {};
}

Expected<PlyHeader> readPlyHeader(std::string_view text) {
    TextScanner scanner(text);
    PlyHeader header;
    if (lowered(scanner.wordAcrossLines().substr(0, 8)) != "ply")
        return Status::data("not a PLY file: it does not begin with the word ply");
    // Where lines end with a lone CR, a line feed after the header is the data's first byte.
    const bool loneReturns = scanner.lineEnd() == "\r";
    bool hasFormat = false;
    while (scanner.nextLine()) {
        const std::string key = lowered(scanner.word());
        Status status;
        if (key == "end_header") {
            if (!hasFormat) return headerFault(scanner, "the header names no format");
            header.dataOffset =
                scanner.offset() - (loneReturns && scanner.lineEnd() == "\r\n" ? 1 : 0);
            return header;
        }
        if (key == "format") {
            status = readFormat(scanner, header);
            hasFormat = true;
        } else if (key == "element") {
            status = readElement(scanner, header);
        } else if (key == "property") {
            status = readProperty(scanner, header);
        } else if (!key.empty() && key != "comment" && key != "obj_info") {
            return headerFault(scanner, "a line that is no part of a PLY header");
        }
        if (!status.ok()) return status;
    }
    return Status::data("the PLY header has no end_header");
}

Status cutShort(const Element& element) {
    return Status::data("the PLY file claims " + std::to_string(element.count) + " items of \"" +
                        element.name + "\", but its data ends or cannot be read before the last");
}

// The fewest bytes or characters that an item takes, and whether the data can hold them all.
Status checkRoom(const Element& element, const NumberSource& source) {
    for (const Property& property : element.properties) {
        const Type first = property.isList() ? property.countType : property.type;
        if (element.count > source.room(first)) return cutShort(element);
    }
    return {};
}

// Reads the count of a list; fails where the data cannot hold it.
bool readListCount(const Property& property, NumberSource& source, std::size_t& count) {
    const double claimed = source.next(property.countType);
    if (source.failed() || !(claimed >= 0 && claimed <= 4294967295.0)) return false;
    count = static_cast<std::size_t>(claimed);
    return static_cast<double>(count) == claimed && count <= source.room(property.type);
}

Status readVertices(const Element& element, NumberSource& source, Mesh& mesh) {
    if (!mesh.vertices.empty()) return Status::data("the PLY file lists its vertices twice");
    std::array<bool, 3> found{};
    for (const Property& property : element.properties)
        for (int axis = 0; axis < 3; ++axis)
            if (!property.isList() && property.name == std::string(1, "xyz"[axis]))
                found[static_cast<std::size_t>(axis)] = true;
    if (!found[0] || !found[1] || !found[2])
        return Status::data("the PLY file's vertices have no x, y and z");
    if (element.count > kMeshVertices) return Status::data("the PLY file has too many vertices");
    mesh.vertices.reserve(element.count);
    for (std::size_t i = 0; i < element.count; ++i) {
        glm::dvec3 vertex{};
        for (const Property& property : element.properties) {
            std::size_t count = 1;
            if (property.isList() && !readListCount(property, source, count))
                return cutShort(element);
            double value = 0;
            for (std::size_t k = 0; k < count; ++k) value = source.next(property.type);
            if (property.isList() || property.name.size() != 1) continue;
            const char axis = property.name[0];
            if (axis >= 'x' && axis <= 'z') vertex[axis - 'x'] = value;
        }
        if (source.failed()) return cutShort(element);
        if (!std::isfinite(vertex.x) || !std::isfinite(vertex.y) || !std::isfinite(vertex.z))
            return Status::data("vertex " + std::to_string(i + 1) +
                                " of the PLY file has a coordinate that is not finite");
        mesh.vertices.push_back(vertex);
    }
    return {};
}

// The list of corners of one face; false where the data ends.
bool readCorners(const Element& element, NumberSource& source, std::vector<double>& corners) {
    corners.clear();
    for (const Property& property : element.properties) {
        std::size_t count = 1;
        if (property.isList() && !readListCount(property, source, count)) return false;
        const bool wanted = property.isList() &&
                            (property.name == "vertex_indices" || property.name == "vertex_index");
        for (std::size_t k = 0; k < count; ++k) {
            const double value = source.next(property.type);
            if (wanted) corners.push_back(value);
        }
    }
    return !source.failed();
}

Status readFaces(const Element& element, NumberSource& source, Mesh& mesh) {
    std::vector<double> corners;
    std::vector<std::uint32_t> indices;
    const auto limit = static_cast<double>(mesh.vertices.size());
    for (std::size_t i = 0; i < element.count; ++i) {
        if (!readCorners(element, source, corners)) return cutShort(element);
        indices.clear();
        for (double corner : corners) {
            if (!(corner >= 0 && corner < limit) || corner != std::floor(corner))
                return Status::data("face " + std::to_string(i + 1) +
                                    " of the PLY file has a corner that is none of the " +
                                    std::to_string(mesh.vertices.size()) + " vertices");
            indices.push_back(static_cast<std::uint32_t>(corner));
        }
        if (mesh.triangles.size() + indices.size() > kMeshTriangles)
            return Status::data("the PLY file has too many triangles");
        appendPolygon(indices, mesh);
    }
    return {};
}

// Strips of triangles, each with the one before it turned over: (a, b, c), (c, b, d), (c, d, e) …
Status readStrips(const Element& element, NumberSource& source, Mesh& mesh) {
    std::vector<double> corners;
    const auto limit = static_cast<double>(mesh.vertices.size());
    for (std::size_t i = 0; i < element.count; ++i) {
        if (!readCorners(element, source, corners)) return cutShort(element);
        std::size_t length = 0;  // of the strip up to here
        std::uint32_t a = 0, b = 0;
        for (const double corner : corners) {
            if (corner == -1) {
                length = 0;
                continue;
            }
            if (!(corner >= 0 && corner < limit) || corner != std::floor(corner))
                return Status::data("strip " + std::to_string(i + 1) +
                                    " of the PLY file has a corner that is none of the " +
                                    std::to_string(mesh.vertices.size()) + " vertices");
            if (mesh.triangles.size() >= kMeshTriangles)
                return Status::data("the PLY file has too many triangles");
            const auto c = static_cast<std::uint32_t>(corner);
            // A corner that stands twice turns the strip and is no triangle.
            if (length >= 2 && a != b && b != c && a != c) {
                if (length % 2 == 0)
                    mesh.triangles.push_back({a, b, c});
                else
                    mesh.triangles.push_back({b, a, c});
            }
            a = b;
            b = c;
            ++length;
        }
    }
    return {};
}

Status skipElement(const Element& element, NumberSource& source) {
    for (std::size_t i = 0; i < element.count; ++i) {
        for (const Property& property : element.properties) {
            std::size_t count = 1;
            if (property.isList() && !readListCount(property, source, count))
                return cutShort(element);
            for (std::size_t k = 0; k < count; ++k) source.next(property.type);
        }
        if (source.failed()) return cutShort(element);
    }
    return {};
}

}  // namespace

bool isPly(std::span<const unsigned char> bytes) {
    TextScanner scanner(textOf(bytes).substr(0, 4096));
    return lowered(scanner.wordAcrossLines().substr(0, 8)) == "ply";
}

Expected<Mesh> readPly(std::span<const unsigned char> bytes) {
    const Expected<PlyHeader> header = readPlyHeader(textOf(bytes));
    if (!header) return header.status();
    NumberSource source(bytes.subspan(header->dataOffset), header->encoding);
    Mesh mesh;
    for (const Element& element : header->elements) {
        // Items without properties take no bytes, so any number of them is nothing to read.
        if (element.properties.empty()) continue;
        Status status = checkRoom(element, source);
        if (!status.ok()) return status;
        if (element.name == "vertex") {
            status = readVertices(element, source, mesh);
        } else if (element.name == "face") {
            status = readFaces(element, source, mesh);
        } else if (element.name == "tristrips") {
            status = readStrips(element, source, mesh);
        } else {
            status = skipElement(element, source);
        }
        if (!status.ok()) return status;
    }
    if (const Status status = finishMesh(mesh, "PLY"); !status.ok()) return status;
    return mesh;
}

}  // namespace versorium
