// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/mesh_reader.h"

#include <cmath>
#include <gmock/gmock.h>

namespace trixel {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

Result<TriangleMesh> read(std::string_view text)
{
    NoProgress progress;
    return parseMesh(MeshFormat::Obj, text, progress);
}

std::string errorOf(std::string_view text)
{
    const auto mesh = read(text);
    return mesh ? "no error" : mesh.error().message;
}

const std::string kVertices = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n";

TEST(ObjReaderTest, readsPositionsAndTrianglesInOrder)
{
    const auto mesh = read("v 0.5 -1e-3 .25\nv 1. +2 3\nv 4 5 6\nf 3 1 2\nf 1 2 3\n");
    ASSERT_TRUE(mesh);
    EXPECT_THAT(
        mesh->positions,
        ElementsAre(glm::vec3(0.5F, -1e-3F, 0.25F), glm::vec3(1, 2, 3), glm::vec3(4, 5, 6)));
    EXPECT_THAT(mesh->triangles, ElementsAre(Triangle{2, 0, 1}, Triangle{0, 1, 2}));
    EXPECT_TRUE(mesh->sourceFaces.empty());
}

TEST(ObjReaderTest, skipsWhatItDoesNotNeed)
{
    const auto mesh = read("\xEF\xBB\xBF# caf\xC3\xA9 C:\\models\\\r\n"
                           "mtllib m\xC3\xBCll.mtl\r\no \xE4\xB8\xAD\r\ng a b#1\r\ns off\r\n\r\n"
                           "v\t0  0\t0 1.0 \r\nv 1 0 0 0.5 0.5 0.5\r\nv 0 1 0 1 0.1 0.2 0.3\r\n"
                           "vt nan 0\r\nvn nan nan nan\r\nvp 1\r\nusemtl x\\y\r\n"
                           "l 1 2\r\np 1\r\n  f 1/1/1 2/1 3//1 # last");
    ASSERT_TRUE(mesh) << mesh.error().message;
    EXPECT_EQ(mesh->positions.size(), 3U);
    EXPECT_THAT(mesh->triangles, ElementsAre(Triangle{0, 1, 2}));
}

TEST(ObjReaderTest, cornersKeepTheirPlacesInAnImage)
{
    const auto mesh = read("v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0.5 0.25\nvt 1.5 -2 7\nvt 3\n"
                           "f 1/1 2/2 3/-3\nf 3/2 2 1/3\n");
    ASSERT_TRUE(mesh) << mesh.error().message;
    ASSERT_TRUE(mesh->hasUvs());
    const auto first = mesh->uvs(faceId(0));
    EXPECT_THAT(first,
                ElementsAre(glm::vec2(0.5F, 0.25F), glm::vec2(1.5F, -2), glm::vec2(0.5F, 0.25F)));
    const auto second = mesh->uvs(faceId(1));
    EXPECT_EQ(second[0], glm::vec2(1.5F, -2));
    EXPECT_TRUE(std::isnan(second[1].x)); // none
    EXPECT_EQ(second[2].x, 3);
    EXPECT_TRUE(std::isnan(second[2].y)); // only one number
}

TEST(ObjReaderTest, placesFollowTheCornersOfCutPolygons)
{
    std::string text = "v 0 0 0\nv 4 0 0\nv 4 4 0\nv 2 1 0\nv 0 4 0\n"
                       "vt 0 0\nvt 4 0\nvt 4 4\nvt 2 1\nvt 0 4\n"
                       "f 1/1 2/2 3/3 4/4 5/5\nf 1/1 2/2 3/3\n";
    const auto mesh = read(text);
    ASSERT_TRUE(mesh) << mesh.error().message;
    ASSERT_EQ(mesh->faceCount(), 4U);
    for (std::size_t face = 0; face < 4; ++face) {
        for (std::size_t corner = 0; corner < 3; ++corner) {
            const glm::vec3 p = mesh->corners(faceId(face))[corner];
            EXPECT_EQ(mesh->uvs(faceId(face))[corner], glm::vec2(p)) << face << ' ' << corner;
        }
    }
}

TEST(ObjReaderTest, aMeshWhoseCornersNameNoPlaceHasNone)
{
    const auto mesh = read("v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nf 1 2 3\n");
    ASSERT_TRUE(mesh) << mesh.error().message;
    EXPECT_FALSE(mesh->hasUvs());
}

TEST(ObjReaderTest, joinsLinesThatEndWithABackslash)
{
    const auto mesh = read("v 0 \\\n0 0\nv 1 0 0\\\r\n\nv 0 1 0\ng a \\\nf b\nf 1 \\\n 2\\\n 3\n");
    ASSERT_TRUE(mesh) << mesh.error().message;
    EXPECT_EQ(mesh->positions.size(), 3U);
    EXPECT_THAT(mesh->triangles, ElementsAre(Triangle{0, 1, 2}));
}

TEST(ObjReaderTest, commentThatEndsWithABackslashSwallowsNothing)
{
    const auto mesh = read("# C:\\tmp\\\nv 0 0 0 # \\\nv 1 0 0\nv 0 1 0\nf 1 2 3 # \\\nf 3 2 1");
    ASSERT_TRUE(mesh) << mesh.error().message;
    EXPECT_EQ(mesh->positions.size(), 3U);
    EXPECT_EQ(mesh->faceCount(), 2U);
}

TEST(ObjReaderTest, negativeNumbersCountBackFromTheirLine)
{
    const auto mesh = read("v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvn 0 0 1\nf -3/-1/-1 -2 -1\n"
                           "v 5 5 5\nf -3 -2 -1\n");
    ASSERT_TRUE(mesh) << mesh.error().message;
    EXPECT_THAT(mesh->triangles, ElementsAre(Triangle{0, 1, 2}, Triangle{1, 2, 3}));
    EXPECT_THAT(errorOf("v 0 0 0\nv 1 0 0\nf -1 -2 -3\nv 0 1 0\n"),
                HasSubstr("line 3: expected a vertex number in -2 to -1, found -3"));
}

TEST(ObjReaderTest, facesMayComeBeforeTheirVertices)
{
    const auto mesh = read("f 1 2 3\n" + kVertices);
    ASSERT_TRUE(mesh);
    EXPECT_THAT(mesh->triangles, ElementsAre(Triangle{0, 1, 2}));
    EXPECT_THAT(errorOf("f 1 2 5\n" + kVertices),
                HasSubstr("line 1: expected a vertex number in 1 to 4, found 5"));
}

TEST(ObjReaderTest, polygonsRememberTheirSourceFace)
{
    const auto mesh = read("v 0 0 0\nv 2 0 0\nv 2 2 0\nv 0 2 0\nv -1 1 0\n"
                           "f 1 2 3\nf 1 2 3 4\nf 1 2 3 4 5\nf 1 3 4\n");
    ASSERT_TRUE(mesh);
    EXPECT_THAT(mesh->sourceFaces, ElementsAre(0, 1, 1, 2, 2, 2, 3));
    EXPECT_EQ(mesh->triangles.front(), (Triangle{0, 1, 2}));
    EXPECT_EQ(mesh->triangles.back(), (Triangle{0, 2, 3}));
}

TEST(ObjReaderTest, errorsNameLineExpectedAndFound)
{
    const std::string number = "expected a finite number that fits a float, found ";
    EXPECT_EQ(errorOf("v 0 0 0\nv 0,5 0 0\n"), "line 2: " + number + "'0,5'");
    EXPECT_EQ(errorOf("v 0 0\n"), "line 1: " + number + "the end of the line");
    EXPECT_EQ(errorOf("v 0 0"), "line 1: " + number + "the end of the file");
    for (const char* bad : {"nan", "-nan", "inf", "1e39", "-1e400", "0x10", "1.5f", "--1", "+-1"}) {
        EXPECT_EQ(errorOf(std::string("v ") + bad + " 0 0\n"),
                  "line 1: " + number + "'" + bad + "'");
    }
    EXPECT_EQ(errorOf("v 0 0 0 1 1\n"), "line 1: expected 3, 4, 6 or 7 numbers, found 5");
    EXPECT_EQ(errorOf("v 0 0 0 1 1 1 1 9\n"), "line 1: expected the end of the line, found '9'");
    EXPECT_EQ(errorOf("v 0 0 0v 1 0 0\n"), "line 1: " + number + "'0v'");
    EXPECT_EQ(errorOf("v 0 0 0 v 1 0 0\n"), "line 1: expected a number, found 'v'");
    EXPECT_EQ(errorOf("\n\nw 0 0 0\n"),
              "line 3: expected an OBJ statement such as 'v' or 'f', found 'w'");
    EXPECT_EQ(errorOf(kVertices + "f 1 2\n"),
              "line 5: expected a face of at least 3 corners, found 2");
    EXPECT_EQ(errorOf(kVertices + "f 1 2 x\n"), "line 5: expected a vertex number, found 'x'");
    EXPECT_EQ(errorOf(kVertices + "vt 0\nvn 0\nf 1 2 3/1/1/1\n"),
              "line 7: expected a corner such as '1', '1/2', '1//3' or '1/2/3', found '3/1/1/1'");
    EXPECT_EQ(errorOf(kVertices + "f 1 2 3/1\n"),
              "line 5: expected a texture vertex number (the file has none), found 1");
    EXPECT_EQ(errorOf(kVertices), "expected at least one face, found none");
    EXPECT_EQ(errorOf(""), "the file is empty");
}

TEST(ObjReaderTest, numbersTooSmallForAFloatAreZero)
{
    const auto mesh = read("v 1e-60 -1e-400 0.0000e999\nv 1 0 0\nv 0 1 0\nf 1 2 3");
    ASSERT_TRUE(mesh) << mesh.error().message;
    EXPECT_EQ(mesh->positions[0], glm::vec3(0));
}

// Longer than several chunks, with continued lines and polygons everywhere.
TEST(ObjReaderTest, chunksJoinWithoutASeam)
{
    std::string text;
    const std::uint32_t count = 120'000;
    for (std::uint32_t i = 0; i < count; ++i) {
        text += "v " + std::to_string(i) + (i % 3 == 0 ? " \\\n" : " ") + "0 0\n";
        text += i % 5 == 0 ? "# padding that ends with a backslash \\\n" : "";
        if (i >= 3) {
            text += i % 2 == 0 ? "f -3 -2 -1\n" : "f -4 -3 \\\n -2 -1\n";
        }
    }
    ASSERT_GT(text.size(), std::size_t{3} << 20U);
    const auto mesh = read(text);
    ASSERT_TRUE(mesh) << mesh.error().message;
    ASSERT_EQ(mesh->positions.size(), count);
    for (std::uint32_t i = 0; i < count; ++i) {
        ASSERT_EQ(mesh->positions[i].x, static_cast<float>(i));
    }
    std::size_t face = 0;
    for (std::uint32_t i = 3; i < count; ++i) {
        ASSERT_EQ(mesh->sourceFace(faceId(face)), i - 3);
        const bool triangle = i % 2 == 0;
        ASSERT_EQ(mesh->triangles[face],
                  (triangle ? Triangle{i - 2, i - 1, i} : Triangle{i - 3, i - 2, i - 1}));
        face += triangle ? 1 : 2;
    }
    EXPECT_EQ(face, mesh->faceCount());
    EXPECT_THAT(errorOf(text + "f 1 2 x\n"),
                HasSubstr("line " + std::to_string(1 + std::ranges::count(text, '\n')) + ":"));
}

TEST(ObjReaderTest, cancelledWorkGivesNoMesh)
{
    class Cancel final : public Progress
    {
        bool report(double /*fraction*/) override { return false; }
    } progress;
    const auto mesh = parseMesh(MeshFormat::Obj, kVertices + "f 1 2 3\n", progress);
    ASSERT_FALSE(mesh);
    EXPECT_EQ(mesh.error().kind, ErrorKind::Cancelled);
}

} // namespace
} // namespace trixel
