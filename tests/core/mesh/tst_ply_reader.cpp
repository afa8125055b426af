// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/mesh_reader.h"
#include "tests/core/mesh/test_data.h"

#include <gmock/gmock.h>

namespace trixel {
namespace {

using test::bigEndian;
using test::littleEndian;
using testing::ElementsAre;
using testing::HasSubstr;

Result<TriangleMesh> read(std::string_view text)
{
    NoProgress progress;
    return parseMesh(MeshFormat::Ply, text, progress);
}

std::string errorOf(std::string_view text)
{
    const auto mesh = read(text);
    return mesh ? "no error" : mesh.error().message;
}

// A header of a vertex with odd neighbours, a foreign element and a face with odd neighbours.
std::string busyHeader(const std::string& format)
{
    return "ply\nformat " + format +
           " 1.0\ncomment caf\xC3\xA9 # 1\nelement camera 2\nproperty list uchar short lens\n"
           "property double tilt\nelement vertex 3\nproperty uchar red\nproperty short x\n"
           "property list int float weights\nproperty double y\nproperty float32 z\n"
           "element marker 5\nelement face 2\nproperty uint16 group\n"
           "property list ushort uint8 vertex_indices\nproperty list char int8 tags\n"
           "obj_info end\nelement edge 1\nproperty int vertex1\nend_header\n";
}

void expectBusyMesh(const Result<TriangleMesh>& mesh)
{
    ASSERT_TRUE(mesh) << mesh.error().message;
    EXPECT_THAT(mesh->positions,
                ElementsAre(glm::vec3(1, 2.5F, 3), glm::vec3(-4, 5, 6), glm::vec3(7, 8, 9.25F)));
    EXPECT_THAT(mesh->triangles, ElementsAre(Triangle{0, 1, 2}, Triangle{2, 1, 0}));
}

template <class Pack>
std::string busyData(Pack pack)
{
    std::string data;
    for (int camera = 0; camera < 2; ++camera) {
        data += pack(std::uint8_t{2}) + pack(std::int16_t{1}) + pack(std::int16_t{2}) + pack(0.5);
    }
    const auto vertex = [&](std::int16_t x, double y, float z, std::int32_t weights) {
        data += pack(std::uint8_t{255}) + pack(x) + pack(weights);
        for (std::int32_t i = 0; i < weights; ++i) {
            data += pack(1.0F);
        }
        data += pack(y) + pack(z);
    };
    vertex(1, 2.5, 3.0F, 0);
    vertex(-4, 5, 6.0F, 3);
    vertex(7, 8, 9.25F, 1);
    for (const int first : {0, 2}) {
        data += pack(std::uint16_t{7}) + pack(std::uint16_t{3});
        data += pack(static_cast<std::uint8_t>(first)) + pack(std::uint8_t{1}) +
                pack(static_cast<std::uint8_t>(2 - first));
        data += pack(std::int8_t{1}) + pack(std::int8_t{-1});
    }
    return data + pack(std::int32_t{0});
}

TEST(PlyReaderTest, skipsElementsAndPropertiesItDoesNotNeed)
{
    expectBusyMesh(read(busyHeader("ascii") +
                        "2 1 2 0.5\n\n2 3 4 inf\n255 1 0 2.5 3\n255 -4 3 1 nan 1 5 6\n"
                        "255\t7 1 0.5 8 9.25 \n7 3 0 1 2 1 -1\n7 3 2 1 0 0\n0\n\n"));
    expectBusyMesh(read(busyHeader("binary_little_endian") +
                        busyData([](auto value) { return littleEndian(value); })));
    expectBusyMesh(read(busyHeader("binary_big_endian") +
                        busyData([](auto value) { return bigEndian(value); })));
}

TEST(PlyReaderTest, facesMayComeBeforeVertices)
{
    const auto mesh =
        read("ply\nformat ascii 1.0\nelement face 1\nproperty list int int vertex_index\n"
             "element vertex 4\nproperty int z\nproperty int y\nproperty int x\nend_header\n"
             "4 0 1 2 3\n0 0 0\n0 0 1\n0 1 1\n0 1 0\n");
    ASSERT_TRUE(mesh) << mesh.error().message;
    EXPECT_EQ(mesh->positions[1], glm::vec3(1, 0, 0));
    EXPECT_THAT(mesh->triangles, ElementsAre(Triangle{0, 1, 2}, Triangle{0, 2, 3}));
    EXPECT_THAT(mesh->sourceFaces, ElementsAre(0, 0));
}

TEST(PlyReaderTest, binaryHeaderMayEndWithCarriageReturn)
{
    std::string header = busyHeader("binary_little_endian");
    for (std::size_t at = 0; (at = header.find('\n', at)) != std::string::npos; at += 2) {
        header.replace(at, 1, "\r\n");
    }
    expectBusyMesh(read(header + busyData([](auto value) { return littleEndian(value); })));
}

const std::string kHeader = "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\n"
                            "property float y\nproperty float z\nelement face 1\n"
                            "property list uchar int vertex_indices\nend_header\n";

TEST(PlyReaderTest, asciiErrorsNameTheirLine)
{
    EXPECT_EQ(errorOf(kHeader + "0 0 0\n1 0\n0 1 0\n3 0 1 2\n"),
              "line 11: expected a finite number that fits a float, found the end of the line");
    EXPECT_EQ(errorOf(kHeader + "0 0 0\n1 0 0 0\n0 1 0\n3 0 1 2\n"),
              "line 11: expected the end of the line, found '0'");
    EXPECT_EQ(errorOf(kHeader + "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n4 5 6\n"),
              "line 14: expected the end of the file, found '4'");
    EXPECT_EQ(errorOf(kHeader + "0 0 0\n1 0 0\n0 1 0\n2 0 1 2\n"),
              "line 13: expected a face of at least 3 corners, found '2'");
    EXPECT_EQ(errorOf(kHeader + "0 0 0\n1 0 0\n0 1 0\n3 0 -1 2\n"),
              "line 13: expected a vertex number below 3, found '-1'");
}

TEST(PlyReaderTest, binaryErrorsNameTheirByte)
{
    const std::string header = busyHeader("binary_little_endian");
    const std::string data = busyData([](auto value) { return littleEndian(value); });
    EXPECT_EQ(errorOf(header + data + "\n"),
              "byte " + std::to_string(header.size() + data.size()) +
                  ": expected the end of the file, found 1 bytes more");
    EXPECT_EQ(errorOf(header + data.substr(0, data.size() - 1)),
              "byte " + std::to_string(header.size() + data.size() - 4) +
                  ": expected a value of 'vertex1', found the end of the file");
}

TEST(PlyReaderTest, headersThatAreNoMeshAreRefused)
{
    const auto without = [](std::string text, const std::string& part) {
        return text.erase(text.find(part), part.size());
    };
    EXPECT_EQ(errorOf(without(kHeader, "property float y\n")),
              "line 3: expected element 'vertex' with a property 'y', found none");
    EXPECT_THAT(errorOf("ply\nformat ascii 1.0\nelement vertex 0\nproperty float x\n"
                        "property float y\nproperty float z\nend_header\n"),
                HasSubstr("expected an element 'face' in the header, found none"));
    EXPECT_EQ(errorOf(without(kHeader, "list uchar ") + "0"),
              "line 8: expected a list of integers, found another type");
    EXPECT_THAT(errorOf(without(kHeader, "element vertex 3\n")),
                HasSubstr("line 3: expected an element before its properties"));
    EXPECT_THAT(errorOf("ply\nformat ascii 1.0\nelement vertex 1\nelement vertex 1\n"),
                HasSubstr("line 4: expected each element once, found 'vertex' again"));
    EXPECT_THAT(errorOf("ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\n"
                        "property float x\nend_header\n"),
                HasSubstr("line 5: expected property 'x' once, found it again"));
    EXPECT_EQ(errorOf("ply\nformat ascii 2.0\n"), "line 2: expected version 1.0, found '2.0'");
    EXPECT_EQ(errorOf("ply\nformat binary 1.0\n"),
              "line 2: expected ascii, binary_little_endian or binary_big_endian, found 'binary'");
    EXPECT_EQ(errorOf("plyx\n"), "line 1: expected 'ply', found 'plyx'");
}

TEST(PlyReaderTest, doublesBeyondFloatAreRefused)
{
    std::string file = "ply\nformat binary_big_endian 1.0\nelement vertex 1\nproperty double x\n"
                       "property float y\nproperty float z\nelement face 1\n"
                       "property list uchar int vertex_indices\nend_header\n";
    const std::size_t start = file.size();
    file += bigEndian(1e39) + bigEndian(0.0F) + bigEndian(0.0F) + '\3' + std::string(12, '\0');
    EXPECT_THAT(errorOf(file), HasSubstr("byte " + std::to_string(start) + ": expected a finite"));
    file.replace(start, 8, bigEndian(1e38));
    EXPECT_TRUE(read(file));
}

} // namespace
} // namespace trixel
