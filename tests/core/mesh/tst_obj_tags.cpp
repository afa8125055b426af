// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/mesh_reader.h"

#include <gmock/gmock.h>

namespace trixel {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

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

Sharpness sharpnessIn(const std::string& text)
{
    const auto mesh = read(text);
    EXPECT_TRUE(mesh) << mesh.error().message;
    return mesh ? mesh->sharpness : Sharpness();
}

/// A pyramid on a square: seven lines.
const std::string kPyramid = "v 0 0 2\nv 0 -2 0\nv 2 0 0\nv 0 2 0\nv -2 0 0\n"
                             "f 1 2 3\nf 1 3 4\nf 1 4 5\nf 1 5 2\nf 5 4 3 2\n";

TEST(ObjTags, creasesAndCornersCountTheirVerticesFromZero)
{
    const Sharpness found = sharpnessIn(kPyramid + "t crease 2/1/0 4 3 3.0\n"
                                                   "t crease  2/1/0  1 2  0.5 # comment\n"
                                                   "t corner 1/1/0 0 2.5\n");
    EXPECT_THAT(found.creases, ElementsAre(Crease{1, 2, 0.5F}, Crease{3, 4, 3.0F}));
    EXPECT_THAT(found.vertices, ElementsAre(SharpVertex{0, 2.5F}));
}

TEST(ObjTags, mayComeBeforeTheVerticesAndFacesTheySpeakOf)
{
    const Sharpness found = sharpnessIn("t crease 2/1/0 0 1 10\r\n" + kPyramid);
    EXPECT_THAT(found.creases, ElementsAre(Crease{0, 1, kSharp}));
}

TEST(ObjTags, theLastOfAnEdgeOrAVertexCounts)
{
    const Sharpness found = sharpnessIn(kPyramid + "t crease 2/1/0 1 2 3\nt crease 2/1/0 0 1 1\n"
                                                   "t crease 2/1/0 2 1 4\nt crease 2/1/0 1 0 0\n"
                                                   "t corner 1/1/0 2 1\nt corner 1/1/0 2 7\n"
                                                   "t corner 1/1/0 3 2\nt corner 1/1/0 3 0\n");
    EXPECT_THAT(found.creases, ElementsAre(Crease{1, 2, 4}));
    EXPECT_THAT(found.vertices, ElementsAre(SharpVertex{2, 7}));
}

TEST(ObjTags, whatIsSharperThanForEverIsSharpForEver)
{
    EXPECT_THAT(sharpnessIn(kPyramid + "t crease 2/1/0 1 2 1e30\n").creases,
                ElementsAre(Crease{1, 2, kSharp}));
}

TEST(ObjTags, othersAreSkippedIfAsMuchFollowsAsTheySay)
{
    const Sharpness found =
        sharpnessIn(kPyramid + "t interpolateboundary 1/0/0 2\nt creasemethod 0/0/1 chaikin\n"
                               "t facevaryinginterpolateboundary 1/0/0 1\nt smooth 0/0/0\n");
    EXPECT_TRUE(found.isEmpty());
    EXPECT_THAT(errorOf(kPyramid + "t hole 2/0/0 1\n"),
                HasSubstr("line 11: expected 2 arguments, found 1"));
    EXPECT_THAT(errorOf(kPyramid + "t hole 1/0/0 1 2\n"),
                HasSubstr("line 11: expected the end of the line, found '2'"));
}

TEST(ObjTags, largeFilesKeepTheirLinesAndTheirOrder)
{
    std::string text = kPyramid;
    for (int k = 0; k < 60'000; ++k) { // several runs of lines, each read by a thread of its own
        text += "t crease 2/1/0 1 2 " + std::to_string(k % 9 + 1) + "\n";
    }
    text += "t crease 2/1/0 2 1 0.25\n";
    EXPECT_THAT(sharpnessIn(text).creases, ElementsAre(Crease{1, 2, 0.25F}));
    EXPECT_THAT(errorOf(text + "t crease 2/1/0 1 3 1\n"), HasSubstr("line 60012"));
}

TEST(ObjTags, damagedOnesAreRefusedWithTheirLine)
{
    const auto refusal = [](const std::string& line) { return errorOf(kPyramid + line + "\n"); };
    EXPECT_THAT(refusal("t"), HasSubstr("line 11: expected the name of a tag"));
    EXPECT_THAT(refusal("t 0.5 0.5"), HasSubstr("line 11: expected the name of a tag"));
    EXPECT_THAT(refusal("t crease"), HasSubstr("line 11: expected how much follows"));
    EXPECT_THAT(refusal("t crease 2/1 0 1 1"), HasSubstr("how much follows"));
    EXPECT_THAT(refusal("t crease 2/1/0x 0 1 1"), HasSubstr("how much follows"));
    EXPECT_THAT(refusal("t crease -2/1/0 0 1 1"), HasSubstr("how much follows"));
    EXPECT_THAT(refusal("t crease 3/1/0 0 1 2 1"), HasSubstr("expected '2/1/0'"));
    EXPECT_THAT(refusal("t corner 1/2/0 0 1 1"), HasSubstr("expected '1/1/0'"));
    EXPECT_THAT(refusal("t crease 2/1/0 0 5 1"),
                HasSubstr("line 11: expected a vertex in 0 to 4 (tags count from 0), found '5'"));
    EXPECT_THAT(refusal("t crease 2/1/0 -1 0 1"), HasSubstr("expected a vertex in 0 to 4"));
    EXPECT_THAT(refusal("t corner 1/1/0 99999999999999999999 1"), HasSubstr("a vertex in 0 to 4"));
    EXPECT_THAT(refusal("t crease 2/1/0 0 1 -1"),
                HasSubstr("line 11: expected a sharpness of 0 or more, found '-1'"));
    EXPECT_THAT(refusal("t crease 2/1/0 0 1 nan"), HasSubstr("expected a sharpness"));
    EXPECT_THAT(refusal("t crease 2/1/0 0 1"), HasSubstr("expected a sharpness"));
    EXPECT_THAT(refusal("t crease 2/1/0 0 1 1 1"), HasSubstr("expected the end of the line"));
    EXPECT_THAT(refusal("t hole 4611686018427387904/4611686018427387904/1 1"),
                HasSubstr("line 11: expected"));
    EXPECT_THAT(
        refusal("t crease 2/1/0 1 3 1"),
        HasSubstr("line 11: expected a crease along an edge, but vertices 1 and 3 share none"));
    EXPECT_THAT(refusal("t crease 2/1/0 1 1 1"), HasSubstr("vertices 1 and 1 share none"));
}

TEST(ObjTags, aFileWithoutVerticesHasNoneToNameEither)
{
    EXPECT_THAT(errorOf("t corner 1/1/0 0 1\n"), HasSubstr("(the file has none)"));
}

TEST(ObjTags, filesWithoutThemAreAsSharpAsBefore)
{
    EXPECT_TRUE(sharpnessIn(kPyramid).isEmpty());
}

} // namespace
} // namespace trixel
