// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/mesh_reader.h"
#include "tests/core/mesh/test_data.h"

#include <cmath>
#include <gmock/gmock.h>
#include <utility>

namespace trixel {
namespace {

using test::bigEndian;
using testing::ElementsAre;
using testing::HasSubstr;

Result<TriangleMesh> read(std::string_view text)
{
    NoProgress progress;
    return parseMesh(MeshFormat::Off, text, progress);
}

std::string errorOf(std::string_view text)
{
    const auto mesh = read(text);
    return mesh ? "no error" : mesh.error().message;
}

void expectSquare(const Result<TriangleMesh>& mesh)
{
    ASSERT_TRUE(mesh) << mesh.error().message;
    EXPECT_THAT(
        mesh->positions,
        ElementsAre(glm::vec3(0), glm::vec3(1, 0, 0), glm::vec3(1, 1, 0), glm::vec3(0, 1, 0)));
    EXPECT_THAT(mesh->triangles, ElementsAre(Triangle{0, 1, 2}, Triangle{0, 2, 3}));
}

TEST(OffReaderTest, readsEveryVariantOpenMeshWrites)
{
    std::size_t files = 0;
    for (const auto& path : test::filesIn("mesh-formats")) {
        SCOPED_TRACE(path);
        NoProgress progress;
        expectSquare(readMesh(path, progress));
        ++files;
    }
    EXPECT_EQ(files, 17U);
}

TEST(OffReaderTest, headerIsFree)
{
    const std::string data = "0 0 0\n1 0 0 # x\n\n1 1 0\n0 1 0\n4 0 1 2 3\n";
    for (const char* header : {"OFF\n4 1 4\n",
                               "OFF 4 1 4\n",
                               "# caf\xC3\xA9\n\nOFF # 4 1\n\n# c\n4 1\n",
                               "\xEF\xBB\xBFOFF\r\n4 1 0\r\n"}) {
        expectSquare(read(header + data));
    }
}

TEST(OffReaderTest, extraNumbersAreSkippedByKind)
{
    expectSquare(read("STCNOFF\n4 2 0\n0 0 0 0 0 1 255 0 0 .5 .5\n1 0 0 0 0 1 1 1 1 1 0 1\n"
                      "1 1 0 0 0 1 255 0 0 0 0\n0 1 0 0 0 1 255 0 0 0 0\n"
                      "3 0 1 2 255 0 0\n3 0 2 3 0.5 0.5 0.5 1\n"));
    EXPECT_EQ(errorOf("NOFF\n1 1 0\n0 0 0\n3 0 0 0\n"),
              "line 3: expected more numbers for a vertex of this kind of OFF, found "
              "the end of the line");
    EXPECT_EQ(errorOf("OFF\n1 1 0\n0 0 0 1\n3 0 0 0\n"),
              "line 3: expected the end of the line, found '1'");
}

// Geomview's layout: big-endian, colours of four floats, a counted colour after each face.
TEST(OffReaderTest, readsBinaryAsGeomviewWritesIt)
{
    for (const bool colours : {false, true}) {
        std::string file = std::string(colours ? "C" : "") + "OFF BINARY\n" + bigEndian(4) +
                           bigEndian(2) + bigEndian(5);
        for (const glm::vec3 p :
             {glm::vec3(0), glm::vec3(1, 0, 0), glm::vec3(1, 1, 0), glm::vec3(0, 1, 0)}) {
            file += bigEndian(p.x) + bigEndian(p.y) + bigEndian(p.z);
            for (int i = 0; i < (colours ? 4 : 0); ++i) {
                file += bigEndian(0.5F);
            }
        }
        file += bigEndian(3) + bigEndian(0) + bigEndian(1) + bigEndian(2) + bigEndian(0);
        file += bigEndian(3) + bigEndian(0) + bigEndian(2) + bigEndian(3);
        file += bigEndian(1) + bigEndian(0.25F);
        expectSquare(read(file));
        EXPECT_THAT(errorOf(file.substr(0, file.size() - 1)), HasSubstr("byte "));
        EXPECT_THAT(errorOf(file + "x"), HasSubstr("expected the end of the file, found 1 bytes"));
    }
}

TEST(OffReaderTest, placesInAnImageAreTheLastNumbersOfAVertex)
{
    const auto text = read("STCNOFF\n3 1 0\n0 0 0 0 0 1 255 0 0 .25 .5\n1 0 0 0 0 1 1 1 1 1 0 1\n"
                           "0 1 0 0 0 1 nan 1\n3 0 1 2\n");
    ASSERT_TRUE(text) << text.error().message;
    ASSERT_TRUE(text->hasUvs());
    EXPECT_EQ(text->uvs(FaceId{0})[0], glm::vec2(0.25F, 0.5F));
    EXPECT_EQ(text->uvs(FaceId{0})[1], glm::vec2(0, 1));
    EXPECT_TRUE(std::isnan(text->uvs(FaceId{0})[2].y)) << "both of its numbers or none";

    std::string binary = "STOFF BINARY\n";
    for (const std::int32_t count : {3, 1, 0}) {
        binary += bigEndian(count);
    }
    for (const auto& [x, y] : {std::pair(0.0F, 0.0F), {1.0F, 0.0F}, {0.0F, 1.0F}}) {
        binary += bigEndian(x) + bigEndian(y) + bigEndian(0.0F) + bigEndian(x / 4) + bigEndian(y);
    }
    for (const std::int32_t number : {3, 0, 1, 2, 0}) {
        binary += bigEndian(number);
    }
    const auto mesh = read(binary);
    ASSERT_TRUE(mesh) << mesh.error().message;
    ASSERT_TRUE(mesh->hasUvs());
    EXPECT_EQ(mesh->uvs(FaceId{0})[1], glm::vec2(0.25F, 0));
    EXPECT_EQ(mesh->uvs(FaceId{0})[2], glm::vec2(0, 1));
    EXPECT_FALSE(read("NOFF\n3 1 0\n0 0 0 0 0 1\n1 0 0 0 0 1\n0 1 0 0 0 1\n3 0 1 2\n")->hasUvs());
}

TEST(OffReaderTest, errorsNameTheirLine)
{
    EXPECT_EQ(errorOf("4OFF\n"),
              "line 1: expected vertices of three dimensions (OFF), found '4OFF'");
    EXPECT_EQ(errorOf("eight 6 12\n"), "line 1: expected OFF, COFF, NOFF or STOFF, found 'eight'");
    EXPECT_EQ(errorOf("OFF\n1 1 0 0\n"),
              "line 2: expected the end of the line after the counts, found '0'");
    EXPECT_EQ(errorOf("OFF\n1 1 0\n0 0 0\n3 0 0 0 1 2 3 4 5\n"),
              "line 4: expected the end of the line, found '5'");
    EXPECT_EQ(errorOf("OFF\n1 1 0\n0 0 0\n2 0 0\n"),
              "line 4: expected a face of at least 3 corners, found '2'");
    EXPECT_EQ(errorOf("OFF\n1 1 0\n0 0 0\n3 0 0 0\n3 0 0 0\n"),
              "line 5: expected the end of the file, found '3'");
    EXPECT_EQ(errorOf("OFF\n1 0 0\n0 0 0\n"), "expected at least one face, found none");
}

} // namespace
} // namespace trixel
