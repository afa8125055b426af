// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/mesh_reader.h"

#include <algorithm>
#include <gmock/gmock.h>

// Legal or widespread ways to write a mesh that a strict reader must not take for damage, and the
// sentences for what stays refused.

namespace trixel {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

Result<TriangleMesh> read(MeshFormat format, std::string_view text)
{
    NoProgress progress;
    return parseMesh(format, text, progress);
}

std::string errorOf(MeshFormat format, std::string_view text)
{
    const auto mesh = read(format, text);
    return mesh ? "no error" : mesh.error().message;
}

void expectTriangle(MeshFormat format, std::string_view text)
{
    SCOPED_TRACE(text);
    const auto mesh = read(format, text);
    ASSERT_TRUE(mesh) << mesh.error().message;
    EXPECT_THAT(mesh->positions, ElementsAre(glm::vec3(0), glm::vec3(1, 0, 0), glm::vec3(0, 1, 0)));
    EXPECT_THAT(mesh->triangles, ElementsAre(Triangle{0, 1, 2}));
}

const std::string kObj = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
const std::string kPlyVertices =
    "element vertex 3\nproperty float x\nproperty float y\nproperty float z\n";
const std::string kPlyFace = "element face 1\nproperty list uchar int vertex_indices\n";
const std::string kPlyData = "end_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
const std::string kPly = "ply\nformat ascii 1.0\n" + kPlyVertices + kPlyFace + kPlyData;
const std::string kStl = "solid a b\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\n"
                         "vertex 0 1 0\nendloop\nendfacet\nendsolid a b\n";
const std::string kOff = "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";

std::string withReturns(std::string text)
{
    std::replace(text.begin(), text.end(), '\n', '\r');
    return text;
}

TEST(MeshVariationsTest, linesMayEndWithCarriageReturnAlone)
{
    expectTriangle(MeshFormat::Obj, withReturns(kObj));
    expectTriangle(MeshFormat::Ply, withReturns(kPly));
    expectTriangle(MeshFormat::Stl, withReturns(kStl));
    expectTriangle(MeshFormat::Off, withReturns(kOff));
    EXPECT_THAT(errorOf(MeshFormat::Obj, withReturns("v 0 0 0\nv 1 0 0\nv 0 1 x\n")),
                HasSubstr("line 3: expected a finite number"));
}

TEST(MeshVariationsTest, commentsMayFollowANumberAtOnce)
{
    expectTriangle(MeshFormat::Obj, "v 0 0 0#a\nv 1 0 0 # b\nv 0 1 0#\nf 1 2 3#last");
    expectTriangle(MeshFormat::Off, "# a\nOFF#b\n3 1 0#c\n0 0 0#d\n1 0 0\n0 1 0\n3 0 1 2#e");
    EXPECT_THAT(errorOf(MeshFormat::Obj, "v 0 0#0\n" + kObj),
                HasSubstr("line 1: expected a finite number"));
}

TEST(MeshVariationsTest, objStatementsOfOtherProgramsAreSkipped)
{
    expectTriangle(MeshFormat::Obj, "newmtl a\nKd 1 0 0\nmap_Kd a b.png\nxform v f\n" + kObj);
}

TEST(MeshVariationsTest, objWordsThatLookLikeDamageAreRefused)
{
    for (const std::string word : {"w", "F", "V", "v1", "f1", "ff", "fv", "\xE9v", "call", "csh"}) {
        EXPECT_THAT(errorOf(MeshFormat::Obj, kObj + word + " 1 2 3\n"),
                    HasSubstr("line 5: expected an OBJ statement"))
            << word;
    }
}

TEST(MeshVariationsTest, offMayLackItsWord)
{
    expectTriangle(MeshFormat::Off, "# no word\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
    expectTriangle(MeshFormat::Off, "3 1\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
    EXPECT_THAT(errorOf(MeshFormat::Off, "0 x 0\n"), HasSubstr("line 1: expected the number of"));
    EXPECT_THAT(errorOf(MeshFormat::Off, "4OFF\n3 1 0\n"), HasSubstr("three dimensions"));
}

TEST(MeshVariationsTest, plyMayNameItsMakerWithoutTheWordComment)
{
    const std::string created = "ply\nformat ascii 1.0\nCreated by Blender3D 247\n";
    expectTriangle(MeshFormat::Ply, created + kPlyVertices + kPlyFace + kPlyData);
    EXPECT_THAT(errorOf(MeshFormat::Ply, "ply\nformat ascii 1.0\nCreated at noon\n"),
                HasSubstr("line 3: expected 'element'"));
}

TEST(MeshVariationsTest, plyWithoutFacesSaysWhatItHas)
{
    const std::string points = "ply\nformat ascii 1.0\n" + kPlyVertices;
    EXPECT_THAT(errorOf(MeshFormat::Ply, points + "end_header\n0 0 0\n1 0 0\n0 1 0\n"),
                HasSubstr("expected an element 'face' in the header, found none: points alone"));
    EXPECT_THAT(errorOf(MeshFormat::Ply,
                        points + "element tristrips 1\nproperty list int int vertex_indices\n"
                                 "end_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"),
                HasSubstr("found triangle strips ('tristrips')"));
}

TEST(MeshVariationsTest, utf16IsNamed)
{
    for (const char* mark : {"\xFF\xFE", "\xFE\xFF"}) {
        for (const MeshFormat format : {MeshFormat::Obj, MeshFormat::Ply, MeshFormat::Off}) {
            EXPECT_THAT(errorOf(format, std::string(mark) + "v"), HasSubstr("found UTF-16"));
        }
    }
}

TEST(MeshVariationsTest, truncatedBinaryStlThatBeginsWithSolidIsNamed)
{
    std::string file = "solid model";
    file.resize(80, '\0');
    file += std::string("\x02\0\0\0", 4) + std::string(50, '\0'); // two facets named, one there
    EXPECT_THAT(errorOf(MeshFormat::Stl, file),
                HasSubstr("a number of facets that matches the file's 134 bytes"));
}

} // namespace
} // namespace trixel
