// SPDX-License-Identifier: MIT
// One wedge, written as programs of the field write it.
#include <gtest/gtest.h>

#include <algorithm>
#include <glm/geometric.hpp>

#include "base/json.h"
#include "io/byte_reader.h"
#include "io/mesh_files.h"

namespace versorium {
namespace {

using Bytes = std::vector<unsigned char>;
using Corners = std::array<std::array<double, 3>, 3>;

constexpr double kWedge[8][3] = {{0, 0, 0},   {2, 0, 0},   {2, 1, 0},   {0, 1, 0},
                                 {0, 0, 1.5}, {1, 0, 1.5}, {1, 1, 1.5}, {0, 1, 1.5}};
constexpr int kSides[6][4] = {{4, 3, 2, 1}, {5, 6, 7, 8}, {1, 2, 6, 5},
                              {3, 4, 8, 7}, {2, 3, 7, 6}, {4, 1, 5, 8}};

Bytes fileOf(std::string_view text) { return {text.begin(), text.end()}; }

std::string point(int corner) {
    return formatNumber(kWedge[corner][0]) + " " + formatNumber(kWedge[corner][1]) + " " +
           formatNumber(kWedge[corner][2]);
}

// With `end` at the end of each line and `corner` between the second and third corner of a face.
std::string wedgeObj(const std::string& end, const std::string& between = " ") {
    std::string text;
    for (int k = 0; k < 8; ++k) text += "v " + point(k) + end;
    for (const auto& side : kSides)
        text += "f " + std::to_string(side[0]) + " " + std::to_string(side[1]) + between +
                std::to_string(side[2]) + " " + std::to_string(side[3]) + end;
    return text;
}

std::vector<std::array<int, 3>> wedgeTriangles() {
    std::vector<std::array<int, 3>> triangles;
    for (const auto& side : kSides) {
        triangles.push_back({side[0] - 1, side[1] - 1, side[2] - 1});
        triangles.push_back({side[0] - 1, side[2] - 1, side[3] - 1});
    }
    return triangles;
}

std::string wedgeStl() {
    std::string text = "solid wedge\n";
    for (const auto& t : wedgeTriangles()) {
        text += " facet normal 0 0 0\n  outer loop\n";
        for (const int corner : t) text += "   vertex " + point(corner) + "\n";
        text += "  endloop\n endfacet\n";
    }
    return text + "endsolid wedge\n";
}

Bytes wedgeBinaryStl(const char* title) {
    Bytes bytes = fileOf(title);
    bytes.resize(80, ' ');
    appendLittleEndian(bytes, std::uint32_t{12});
    for (const auto& t : wedgeTriangles()) {
        for (int k = 0; k < 3; ++k) appendLittleEndian(bytes, 0.0F);
        for (const int corner : t)
            for (const double part : kWedge[corner])
                appendLittleEndian(bytes, static_cast<float>(part));
        appendLittleEndian<std::uint16_t>(bytes, 0);
    }
    return bytes;
}

std::string wedgePly(const std::string& end) {
    std::string text = "ply" + end + "format ascii 1.0" + end + "element vertex 8" + end +
                       "property float x" + end + "property float y" + end + "property float z" +
                       end + "element face 6" + end + "property list uchar int vertex_indices" +
                       end + "end_header" + end;
    for (int k = 0; k < 8; ++k) text += point(k) + end;
    for (const auto& side : kSides) {
        text += "4";
        for (const int corner : side) text += " " + std::to_string(corner - 1);
        text += end;
    }
    return text;
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
    for (std::size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size())
        text.replace(at, from.size(), to);
    return text;
}

std::string upper(std::string text) {
    for (char& c : text)
        if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
    return text;
}

// The volume enclosed and the sum of areas, which no order of triangles or corners changes.
void expectWedge(const Expected<Mesh>& mesh, const char* what) {
    ASSERT_TRUE(mesh.ok()) << what << ": " << mesh.status().message();
    EXPECT_EQ(mesh->triangles.size(), 12u) << what;
    double volume = 0, area = 0;
    for (const auto& t : mesh->triangles) {
        const glm::dvec3 a = mesh->vertices[t[0]], b = mesh->vertices[t[1]],
                         c = mesh->vertices[t[2]];
        volume += glm::dot(a, glm::cross(b, c)) / 6;
        area += glm::length(glm::cross(b - a, c - a)) / 2;
    }
    EXPECT_NEAR(volume, 2.25, 1e-12) << what;  // (2 + 1)/2 · 1.5
    // Two trapezoids, floor, roof, the upright and the slanting side.
    EXPECT_NEAR(area, 2 * 2.25 + 2 + 1 + 1.5 + std::sqrt(1 + 1.5 * 1.5), 1e-12) << what;
}

TEST(MeshSpellings, ObjByLineEndsMarksAndContinuations) {
    const std::string plain = wedgeObj("\n");
    const std::pair<const char*, std::string> spellings[] = {
        {"plain", plain},
        {"CRLF", wedgeObj("\r\n")},
        {"CR alone", wedgeObj("\r")},
        {"mark", "\xef\xbb\xbf" + plain},
        {"mark and blank lines", "\xef\xbb\xbf\n\r\n  \n" + plain},
        {"no last line end", plain.substr(0, plain.size() - 1)},
        {"continued", wedgeObj("\n", " \\\n  ")},
        {"continued, glued", wedgeObj("\n", "\\\n")},
        {"continued, glued, CRLF", wedgeObj("\r\n", "\\\r\n")},
        {"continued, glued, CR", wedgeObj("\r", "\\\r")},
        {"continued, blanks after", wedgeObj("\n", " \\  \n ")},
        {"vertices continued", replaced(plain, "v 2 1 0", "v 2\\\n1 \\\n0")},
        {"a comment is not continued", "# C:\\models\\\n" + plain},
        {"tabs", replaced(plain, " ", "\t")},
        {"colours and weights", replaced(plain, "v 2 1 0", "v 2 1 0 1.0 0.5 0.5")},
    };
    for (const auto& [what, text] : spellings) expectWedge(readMesh(fileOf(text)), what);
}

TEST(MeshSpellings, LinesOfContinuedFilesAreCounted) {
    const Expected<Mesh> mesh = readObj(fileOf("v 0 \\\n0 0\r\rv 1 0\\\n\\\n0\nv x 0 0\n"));
    ASSERT_FALSE(mesh.ok());
    EXPECT_EQ(mesh.status().message(),
              "line 7 of the OBJ file: a coordinate is expected: \"x\" is not a number");
}

TEST(MeshSpellings, StlByCaseAndTrailingBytes) {
    const std::string plain = wedgeStl();
    const std::pair<const char*, std::string> texts[] = {
        {"plain", plain},
        {"upper case", upper(plain)},
        {"first letters", replaced(replaced(plain, "solid", "Solid"), "vertex", "Vertex")},
        {"blanks before", "\n  \t" + plain},
        {"mark", "\xef\xbb\xbf" + plain},
        {"CR alone", replaced(plain, "\n", "\r")},
        {"CRLF", replaced(plain, "\n", "\r\n")},
        {"no name", replaced(plain, " wedge", "")},
        {"a name that misleads", replaced(plain, "solid wedge", "solid vertex 1")},
        {"no line ends", replaced(plain, "\n", " ")},
        {"no solid line", plain.substr(12)},
    };
    for (const auto& [what, text] : texts) {
        expectWedge(readMesh(fileOf(text)), what);
        expectWedge(readMesh(fileOf(text), "wedge.obj"), what);
    }
    for (const char* title : {"made for a test", "solid Build Plate", "SOLID", "  solid facet"})
        for (const std::size_t trailing : {0, 1, 2, 49, 50, 51, 1000}) {
            Bytes bytes = wedgeBinaryStl(title);
            bytes.resize(bytes.size() + trailing, 'x');
            expectWedge(readMesh(bytes, "wedge.stl"), title);
        }
}

TEST(MeshSpellings, PlyByLineEndsCaseAndStrips) {
    const std::string plain = wedgePly("\n");
    const std::pair<const char*, std::string> texts[] = {
        {"plain", plain},
        {"CRLF", wedgePly("\r\n")},
        {"CR alone", wedgePly("\r")},
        {"blank line", "\n" + plain},
        {"mark", "\xef\xbb\xbf" + plain},
        {"upper case", upper(plain)},
    };
    for (const auto& [what, text] : texts) expectWedge(readMesh(fileOf(text)), what);

    // A strip for each side, and one that goes on after a corner given twice.
    std::string strips =
        replaced(plain.substr(0, plain.find("\n4 ") + 1), "element face 6", "element tristrips 1");
    strips += "31 2 1 3 0 0 5 5 6 4 7 -1 1 5 0 4 -1 3 7 2 6 -1 2 6 1 5 -1 0 4 3 7 -1\n";
    const Expected<Mesh> mesh = readMesh(fileOf(strips));
    expectWedge(mesh, "strips");
}

TEST(MeshSpellings, BinaryPlyAfterAHeaderOfLoneReturns) {
    // The first byte of the data is a line feed, which belongs to no line end.
    Bytes bytes = fileOf(
        "ply\rformat binary_little_endian 1.0\relement vertex 3\rproperty uchar n\r"
        "property float x\rproperty float y\rproperty float z\relement face 1\r"
        "property list uchar uchar vertex_indices\rend_header\r");
    const float corners[3][3] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    for (const auto& corner : corners) {
        bytes.push_back('\n');
        for (const float part : corner) appendLittleEndian(bytes, part);
    }
    for (const int byte : {3, 0, 1, 2}) bytes.push_back(static_cast<unsigned char>(byte));
    const Expected<Mesh> mesh = readMesh(bytes);
    ASSERT_TRUE(mesh.ok()) << mesh.status().message();
    EXPECT_EQ(mesh->vertices[1], glm::dvec3(1, 0, 0));
}

TEST(MeshSpellings, WhatIsNoNumberIsNamed) {
    const std::string obj = wedgeObj("\n"), stl = wedgeStl(), ply = wedgePly("\n");
    for (const char* word : {"nan", "NaN", "-nan(ind)", "1.#QNAN", "inf", "-1.#INF", "1e999"}) {
        for (const std::string& text : {obj, stl, ply}) {
            const Expected<Mesh> mesh =
                readMesh(fileOf(replaced(text, "2 1 0", std::string("2 ") + word + " 0")));
            ASSERT_FALSE(mesh.ok()) << word;
            EXPECT_NE(mesh.status().message().find("finite"), std::string::npos)
                << word << ": " << mesh.status().message();
        }
        // Where nobody looks it harms nobody: a normal, a quality.
        expectWedge(readMesh(fileOf(replaced(stl, "normal 0", std::string("normal ") + word))),
                    word);
        std::string more =
            replaced(ply, "property float z\n", "property float z\nproperty float q\n");
        for (int k = 7; k >= 0; --k) {
            const std::size_t at = more.rfind("\n" + point(k) + "\n");
            more.insert(at + 1 + point(k).size(), std::string(" ") + word);
        }
        expectWedge(readMesh(fileOf(more)), word);
    }
    const Expected<Mesh> comma = readMesh(fileOf(replaced(obj, "v 0 0 1.5", "v 0 0 1,5")));
    ASSERT_FALSE(comma.ok());
    EXPECT_NE(comma.status().message().find("decimal comma"), std::string::npos);
}

TEST(MeshSpellings, ContentDecidesNotTheEnding) {
    for (const char* name : {"", "a.obj", "a.ply", "a.stl", "a.STL", "a.txt"}) {
        expectWedge(readMesh(fileOf(wedgeObj("\n")), name), name);
        expectWedge(readMesh(fileOf(wedgePly("\n")), name), name);
        expectWedge(readMesh(fileOf(wedgeStl()), name), name);
        expectWedge(readMesh(wedgeBinaryStl("x"), name), name);
    }
    const std::pair<std::string, const char*> foreign[] = {
        {"glTF\x02", "glTF"},
        {"PK\x03\x04", "3MF"},
        {"OFF\n3 1 0\n", "OFF"},
        {"<?xml version=\"1.0\"?>\n<COLLADA>", "COLLADA"},
        {"ISO-10303-21;", "STEP"}};
    for (const auto& [bytes, format] : foreign) {
        const Expected<Mesh> mesh = readMesh(fileOf(bytes), "a.obj");
        ASSERT_FALSE(mesh.ok());
        EXPECT_NE(mesh.status().message().find(format), std::string::npos)
            << mesh.status().message();
    }
}

}  // namespace
}  // namespace versorium
