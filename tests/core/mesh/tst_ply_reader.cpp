// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/mesh_reader.h"
#include "tests/core/mesh/test_data.h"

#include <cmath>
#include <gmock/gmock.h>
#include <utility>

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

TEST(PlyReaderTest, uvsOfVerticesByAnyOfTheirNames)
{
    for (const auto& [u, v] : {std::pair("s", "t"),
                               std::pair("u", "v"),
                               std::pair("texture_u", "texture_v"),
                               std::pair("texture_s", "texture_t")}) {
        const auto mesh = read("ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\n"
                               "property float " +
                               std::string(v) +
                               "\nproperty float y\n"
                               "property float z\nproperty double " +
                               std::string(u) +
                               "\nelement face 1\nproperty list uchar int vertex_indices\n"
                               "end_header\n0 .1 0 0 .2\n1 .3 0 0 .4\n1 .5 1 0 .6\n0 .7 1 0 nan\n"
                               "4 0 1 2 3\n");
        ASSERT_TRUE(mesh) << mesh.error().message;
        ASSERT_EQ(mesh->cornerUvs.size(), 6U);
        EXPECT_EQ(mesh->uvs(FaceId{0})[0], glm::vec2(0.2F, 0.1F));
        EXPECT_EQ(mesh->uvs(FaceId{0})[1], glm::vec2(0.4F, 0.3F));
        // The fourth has none: both of its numbers count or neither.
        const auto last = mesh->uvs(FaceId{1});
        const Triangle& triangle = mesh->triangles[1];
        for (std::size_t c = 0; c < 3; ++c) {
            EXPECT_EQ(std::isnan(last[c].x) && std::isnan(last[c].y), triangle[c] == 3);
        }
    }
}

TEST(PlyReaderTest, uvsOfCornersComeBeforeThoseOfVertices)
{
    const std::string header =
        "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\n"
        "property float z\nproperty float s\nproperty float t\nelement face 2\n";
    const std::string vertices = "0 0 0 9 9\n1 0 0 9 9\n0 1 0 9 9\n1 1 0 9 9\n";
    const std::string indices = "property list uchar int vertex_indices\n";
    const std::string places = "property list uchar float texcoord\n";
    const auto expectPlaces = [](const Result<TriangleMesh>& mesh) {
        ASSERT_TRUE(mesh) << mesh.error().message;
        ASSERT_EQ(mesh->cornerUvs.size(), 6U);
        EXPECT_EQ(mesh->uvs(FaceId{0})[2], glm::vec2(0.5F, 0.6F));
        EXPECT_TRUE(std::isnan(mesh->uvs(FaceId{1})[0].x)); // an empty list: no places
    };
    expectPlaces(read(header + indices + places + "end_header\n" + vertices +
                      "3 0 1 2 6 .1 .2 .3 .4 .5 .6\n3 3 2 1 0\n"));
    expectPlaces(read(header + places + indices + "end_header\n" + vertices +
                      "6 .1 .2 .3 .4 .5 .6 3 0 1 2\n0 3 3 2 1\n"));
}

TEST(PlyReaderTest, uvsOfCornersFollowPolygonsThroughTheCut)
{
    const auto pack = [](auto value) { return littleEndian(value); };
    std::string text = "ply\nformat binary_little_endian 1.0\nelement vertex 4\nproperty float x\n"
                       "property float y\nproperty float z\nelement face 1\n"
                       "property list uchar uchar vertex_indices\n"
                       "property list int double texcoord\nend_header\n";
    for (const auto& [x, y] : {std::pair(0.0F, 0.0F), {2.0F, 0.0F}, {2.0F, 2.0F}, {0.0F, 2.0F}}) {
        text += pack(x) + pack(y) + pack(0.0F);
    }
    text += pack(std::uint8_t{4});
    for (std::uint8_t k = 0; k < 4; ++k) {
        text += pack(k);
    }
    text += pack(std::int32_t{8});
    for (const double place : {0.0, 0.0, 1.0, 0.0, 1.0, 1.0, 0.0, 1.0}) {
        text += pack(place);
    }
    const auto mesh = read(text);
    ASSERT_TRUE(mesh) << mesh.error().message;
    ASSERT_EQ(mesh->cornerUvs.size(), 6U);
    for (std::uint32_t f = 0; f < 2; ++f) {
        for (std::size_t c = 0; c < 3; ++c) { // places are half of the positions
            EXPECT_EQ(2.0F * mesh->uvs(FaceId{f})[c], glm::vec2(mesh->corners(FaceId{f})[c]));
        }
    }
}

TEST(PlyReaderTest, whatOnlyLooksLikeUvsIsPassedOver)
{
    const std::string data = "end_header\n0 0 0 1 5\n1 0 0 1 5\n0 1 0 1 5\n3 0 1 2\n";
    const std::string faces = "element face 1\nproperty list uchar int vertex_indices\n";
    const std::string start = "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\n"
                              "property float y\nproperty float z\n";
    const auto alone = read(start + "property float s\nproperty float q\n" + faces + data);
    ASSERT_TRUE(alone) << alone.error().message;
    EXPECT_FALSE(alone->hasUvs());
    const auto list = read(start + "property list int int s\nproperty float t\n" + faces +
                           "end_header\n0 0 0 1 7 5\n1 0 0 0 5\n0 1 0 1 7 5\n3 0 1 2\n");
    ASSERT_TRUE(list) << list.error().message;
    EXPECT_FALSE(list->hasUvs());
    const auto single = read(start + faces +
                             "property float texcoord\nend_header\n"
                             "0 0 0\n1 0 0\n0 1 0\n3 0 1 2 5\n");
    ASSERT_TRUE(single) << single.error().message;
    EXPECT_FALSE(single->hasUvs());
    // No number at all.
    const auto none = read(start + "property float s\nproperty float t\n" + faces +
                           "end_header\n0 0 0 nan 1\n1 0 0 inf 1\n0 1 0 1 1e99\n3 0 1 2\n");
    ASSERT_TRUE(none) << none.error().message;
    EXPECT_FALSE(none->hasUvs());
}

TEST(PlyReaderTest, uvsThatDoNotAddUpAreRefused)
{
    const std::string start = "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\n"
                              "property float y\nproperty float z\nelement face 1\n"
                              "property list uchar int vertex_indices\n"
                              "property list int float texcoord\nend_header\n"
                              "0 0 0\n1 0 0\n0 1 0\n";
    EXPECT_THAT(errorOf(start + "3 0 1 2 4 0 0 1 1\n"),
                testing::AllOf(HasSubstr("line 14"), HasSubstr("6 numbers in list 'texcoord'")));
    EXPECT_THAT(errorOf(start + "3 0 1 2 5 0 0 1 1 0\n"), HasSubstr("an even length"));
    EXPECT_THAT(errorOf(start + "3 0 1 2 -2\n"), HasSubstr("an even length"));
    EXPECT_THAT(errorOf(start + "3 0 1 2 6 0 0 1 1 0\n"), HasSubstr("a number of list"));
    EXPECT_THAT(errorOf(start + "3 0 1 2 6 0 0 1 1 0 x\n"), HasSubstr("a number of list"));
    EXPECT_THAT(errorOf(start + "3 0 1 2 2000000000 0 0\n"), HasSubstr("fits the rest"));
    EXPECT_THAT(errorOf("ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\n"
                        "property float y\nproperty float z\nproperty float s\nproperty float t\n"
                        "property float s\nelement face 1\n"
                        "property list uchar int vertex_indices\nend_header\n"),
                HasSubstr("property 's' once"));
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
