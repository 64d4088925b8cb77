// SPDX-License-Identifier: MIT
#include "io/mesh_files.h"

#include <gtest/gtest.h>

#include <cstring>
#include <functional>

#include "base/json.h"
#include "base/random.h"
#include "io/byte_reader.h"
#include "shape/test_meshes.h"

namespace versorium {
namespace {

using Bytes = std::vector<unsigned char>;

Bytes bytesOf(std::string_view text) { return {text.begin(), text.end()}; }

// Coordinates that a float holds, so that STL and float PLY bring them back exactly. (g++ 12.2
// loses the rounding when it joins neighbouring conversions to float and back; what is volatile
// it leaves alone.)
Mesh sample() {
    Mesh mesh = icosphere(1);
    for (glm::dvec3& v : mesh.vertices)
        for (int axis = 0; axis < 3; ++axis) {
            const volatile float rounded = static_cast<float>(v[axis]);
            v[axis] = rounded;
        }
    return mesh;
}

std::string pointText(const glm::dvec3& v) {
    return formatNumber(v.x) + " " + formatNumber(v.y) + " " + formatNumber(v.z);
}

std::string objText(const Mesh& mesh, const std::function<std::string(std::uint32_t)>& corner) {
    std::string text = "# a sphere\nmtllib none.mtl\no sphere\n";
    for (const glm::dvec3& v : mesh.vertices) text += "v " + pointText(v) + "\n";
    text += "vt 0 0\nvn 0 0 1\ns off\n";
    for (const auto& t : mesh.triangles)
        text += "f " + corner(t[0]) + " " + corner(t[1]) + "  " + corner(t[2]) + " \r\n";
    return text;
}

std::string plyHeader(const char* format, const Mesh& mesh, const char* real) {
    return std::string("ply\nformat ") + format + " 1.0\ncomment made for a test\n" +
           "element vertex " + std::to_string(mesh.vertices.size()) +
           "\nproperty uchar red\nproperty " + real + " x\nproperty " + real + " y\nproperty " +
           real + " z\nproperty list uchar short tags\nelement edge 1\nproperty int a\n" +
           "element face " + std::to_string(mesh.triangles.size()) +
           "\nproperty double quality\nproperty list uchar int vertex_indices\nend_header\n";
}

template <class T>
void appendNumber(Bytes& bytes, T value, bool big) {
    Bytes raw;
    appendLittleEndian(raw, value);
    if (big) std::reverse(raw.begin(), raw.end());
    bytes.insert(bytes.end(), raw.begin(), raw.end());
}

template <class Real>
Bytes plyBinary(const Mesh& mesh, bool big) {
    Bytes bytes = bytesOf(plyHeader(big ? "binary_big_endian" : "binary_little_endian", mesh,
                                    sizeof(Real) == 4 ? "float" : "float64"));
    for (const glm::dvec3& v : mesh.vertices) {
        appendNumber<std::uint8_t>(bytes, 200, big);
        for (int axis = 0; axis < 3; ++axis) appendNumber(bytes, static_cast<Real>(v[axis]), big);
        appendNumber<std::uint8_t>(bytes, 2, big);
        for (int k = 0; k < 2; ++k) appendNumber<std::int16_t>(bytes, -7, big);
    }
    appendNumber<std::int32_t>(bytes, 5, big);
    for (const auto& t : mesh.triangles) {
        appendNumber(bytes, 0.5, big);
        appendNumber<std::uint8_t>(bytes, 3, big);
        for (std::uint32_t corner : t) appendNumber(bytes, static_cast<std::int32_t>(corner), big);
    }
    return bytes;
}

Bytes stlBinary(const Mesh& mesh, const char* title) {
    Bytes bytes = bytesOf(title);
    bytes.resize(80);
    appendLittleEndian(bytes, static_cast<std::uint32_t>(mesh.triangles.size()));
    for (const auto& t : mesh.triangles) {
        for (int k = 0; k < 3; ++k) appendLittleEndian(bytes, 0.0F);
        for (std::uint32_t corner : t)
            for (int axis = 0; axis < 3; ++axis)
                appendLittleEndian(bytes, static_cast<float>(mesh.vertices[corner][axis]));
        appendLittleEndian<std::uint16_t>(bytes, 0);
    }
    return bytes;
}

std::string stlText(const Mesh& mesh) {
    std::string text = "solid ball\n";
    for (const auto& t : mesh.triangles) {
        text += " facet normal 0 0 0\n  outer loop\n";
        for (std::uint32_t corner : t)
            text += "   vertex " + pointText(mesh.vertices[corner]) + "\n";
        text += "  endloop\n endfacet\n";
    }
    return text + "endsolid ball\n";
}

// The same triangles in the same order, whatever the numbers of their corners.
void expectSame(const Expected<Mesh>& read, const Mesh& mesh) {
    ASSERT_TRUE(read.ok()) << read.status().message();
    EXPECT_EQ(read->vertices.size(), mesh.vertices.size());
    ASSERT_EQ(read->triangles.size(), mesh.triangles.size());
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
        for (std::size_t k = 0; k < 3; ++k)
            ASSERT_EQ(read->vertices[read->triangles[i][k]], mesh.vertices[mesh.triangles[i][k]]);
}

TEST(MeshFiles, ObjInEveryFaceSyntax) {
    const Mesh mesh = sample();
    const auto count = static_cast<long>(mesh.vertices.size());
    const std::function<std::string(std::uint32_t)> syntaxes[] = {
        [](std::uint32_t i) { return std::to_string(i + 1); },
        [](std::uint32_t i) { return std::to_string(i + 1) + "/1"; },
        [](std::uint32_t i) { return std::to_string(i + 1) + "//1"; },
        [](std::uint32_t i) { return std::to_string(i + 1) + "/99999999999999999999/-1"; },
        [&](std::uint32_t i) { return std::to_string(static_cast<long>(i) - count) + "/-1/-1"; }};
    for (const auto& corner : syntaxes)
        expectSame(readMesh(bytesOf(objText(mesh, corner)), "ball.OBJ"), mesh);
}

TEST(MeshFiles, ConvexObjPolygonsAreFans) {
    const Expected<Mesh> mesh =
        readObj(bytesOf("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0 1.0\nf 1 2 \\\n 3 4 # square\n"));
    ASSERT_TRUE(mesh.ok()) << mesh.status().message();
    ASSERT_EQ(mesh->triangles.size(), 2u);
    EXPECT_EQ(mesh->triangles[1], (std::array<std::uint32_t, 3>{0, 2, 3}));
}

TEST(MeshFiles, PlyInEveryEncoding) {
    const Mesh mesh = sample();
    std::string text = plyHeader("ascii", mesh, "float");
    for (const glm::dvec3& v : mesh.vertices) text += "200 " + pointText(v) + " 2 -7 -7\n";
    text += "5\n";
    for (const auto& t : mesh.triangles)
        text += "0.5 3 " + std::to_string(t[0]) + " " + std::to_string(t[1]) + "\n" +
                std::to_string(t[2]) + "\n";
    expectSame(readMesh(bytesOf(text)), mesh);
    for (const bool big : {false, true}) {
        expectSame(readMesh(plyBinary<float>(mesh, big)), mesh);
        expectSame(readMesh(plyBinary<double>(mesh, big)), mesh);
    }
}

TEST(MeshFiles, StlInBothEncodings) {
    const Mesh mesh = sample();
    expectSame(readMesh(bytesOf(stlText(mesh))), mesh);
    expectSame(readMesh(stlBinary(mesh, "made for a test")), mesh);
    // The word that begins a text file does not make a binary one text.
    expectSame(readMesh(stlBinary(mesh, "solid by some exporters")), mesh);
}

std::string faultOf(const Expected<Mesh>& mesh) { return mesh.ok() ? "" : mesh.status().message(); }

TEST(MeshFiles, ObjFaultsNameTheirLine) {
    const std::string start = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
    EXPECT_EQ(
        faultOf(readObj(bytesOf(start + "f 1 2 4\n"))),
        "line 4 of the OBJ file: the face's corner \"4\" is none of the 3 vertices before it");
    for (const char* line : {"f 0 1 2", "f -4 1 2", "f 1 2", "f", "f 1 2 x", "f 1 2 3.5",
                             "f 1 2 /3", "f 1 2 99999999999999999999", "f 1 2 -9223372036854775808",
                             "v 1 2", "v 1 2 nan", "v 1 2 inf", "v 1 2 1e999", "v 0x1 0 0"})
        EXPECT_EQ(faultOf(readObj(bytesOf(start + line + "\n"))).find("line 4 of the OBJ file: "),
                  0u)
            << line;
    EXPECT_NE(faultOf(readObj(bytesOf(start))).find("no faces"), std::string::npos);
    EXPECT_NE(faultOf(readObj({})), "");
}

TEST(MeshFiles, PlyCountsAreCheckedAgainstTheBytes) {
    for (const char* count : {"2147483647", "2147483648", "2147483649", "4294967296",
                              "1099511627776", "9223372036854775807", "9223372036854775808",
                              "6148914691236517206", "-1", "1e9", "x", ""})
        for (const char* format : {"ascii", "binary_little_endian", "binary_big_endian"})
            for (const char* element : {"vertex", "face", "other"}) {
                std::string text = std::string("ply\nformat ") + format + " 1.0\nelement " +
                                   element + " " + count +
                                   "\nproperty float x\nproperty float y\nproperty float z\n"
                                   "end_header\n0 0 0 1 1 1 2 2 2 3 3 3 4 4 4\n";
                EXPECT_NE(faultOf(readMesh(bytesOf(text))), "") << text;
            }
    // A list that claims more than there is, by every type of count.
    for (const char* type : {"uchar", "ushort", "uint", "int", "char"}) {
        Bytes bytes = bytesOf(std::string("ply\nformat binary_little_endian 1.0\n"
                                          "element vertex 1\nproperty float x\nproperty float y\n"
                                          "property float z\nelement face 1\nproperty list ") +
                              type + " int vertex_index\nend_header\n");
        bytes.resize(bytes.size() + 12, 0);
        bytes.resize(bytes.size() + 12, 255);
        EXPECT_NE(faultOf(readPly(bytes)), "") << type;
    }
}

TEST(MeshFiles, StlCountsAreCheckedAgainstTheBytes) {
    Bytes bytes = stlBinary(sample(), "x");
    for (std::uint32_t count : {0u, 81u, 2147483647u, 2147483648u, 4294967295u}) {
        std::memcpy(bytes.data() + 80, &count, 4);
        EXPECT_NE(faultOf(readStl(bytes)), "") << count;
    }
    EXPECT_NE(faultOf(readStl(Bytes(83, 0))), "");
    EXPECT_NE(faultOf(readStl(bytesOf("solid x\nfacet\nvertex 0 0 0\nendfacet\n"))), "");
    EXPECT_NE(faultOf(readStl(bytesOf("solid x\nvertex 0 0 0\n"))), "");
    EXPECT_NE(faultOf(readMesh({})), "");
    EXPECT_NE(faultOf(readMesh(bytesOf("hello"), "x.txt")), "");
}

// Torn and scribbled files give a mesh whose indices fit, or a message; never a crash.
TEST(MeshFiles, MutatedFilesAreRefusedOrSound) {
    const Mesh mesh = sample();
    const std::string obj =
        objText(mesh, [](std::uint32_t i) { return std::to_string(i + 1) + "/1/1"; });
    Random random(17);
    for (const Bytes& original :
         {bytesOf(obj), plyBinary<float>(mesh, false), plyBinary<double>(mesh, true),
          stlBinary(mesh, "x"), bytesOf(stlText(mesh))})
        for (int i = 0; i < 300; ++i) {
            Bytes bytes = original;
            for (std::uint64_t k = random.below(6); k > 0; --k)
                bytes[random.below(bytes.size())] = static_cast<unsigned char>(random.next());
            if (random.below(2) == 0) bytes.resize(random.below(bytes.size()));
            const Expected<Mesh> read = readMesh(bytes);
            if (!read.ok()) continue;
            for (const auto& t : read->triangles)
                for (std::uint32_t corner : t) ASSERT_LT(corner, read->vertices.size());
        }
}

}  // namespace
}  // namespace versorium
