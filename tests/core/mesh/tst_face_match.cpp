// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/face_match.h"
#include "tests/core/cancel_after.h"
#include "tests/core/mesh/cages.h"
#include "tests/core/mesh/meshes.h"
#include "tests/core/mesh/shuffled_faces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <gmock/gmock.h>
#include <random>

using namespace trixel;
using test::ragged;
using test::shuffled;
using test::Shuffled;
using test::Winding;
using testing::HasSubstr;

namespace {

Result<FaceMatch> byPositions(const TriangleMesh& mesh, const TriangleMesh& other)
{
    NoProgress progress;
    return matchByPositions(mesh, other, progress);
}

Result<FaceMatch> byNeighbours(const TriangleMesh& mesh, const TriangleMesh& other)
{
    NoProgress progress;
    return matchByNeighbours(
        buildAdjacency(mesh.triangles), buildAdjacency(other.triangles), progress);
}

/// Every face is like every other. \param shift  columns by which the last row meets the first
std::vector<Triangle> torus(std::uint32_t side, std::uint32_t shift)
{
    std::vector<Triangle> triangles;
    const auto vertex = [&](std::uint32_t x, std::uint32_t y) {
        return y % side * side + (x + (y == side ? shift : 0)) % side;
    };
    for (std::uint32_t y = 0; y < side; ++y) {
        for (std::uint32_t x = 0; x < side; ++x) {
            triangles.push_back({vertex(x, y), vertex(x + 1, y), vertex(x, y + 1)});
            triangles.push_back({vertex(x + 1, y), vertex(x + 1, y + 1), vertex(x, y + 1)});
        }
    }
    return triangles;
}

} // namespace

TEST(FaceMatch, positionsFindEveryOrderTurnAndWinding)
{
    const TriangleMesh mesh = ragged();
    for (unsigned seed = 0; seed < 12; ++seed) {
        const Shuffled other = shuffled(mesh, seed, Winding::Random);
        const auto match = byPositions(mesh, other.mesh);
        ASSERT_TRUE(match.has_value()) << match.error().message;
        EXPECT_EQ(*match, other.match);
        EXPECT_FALSE(isIdentity(*match));
    }
    EXPECT_TRUE(isIdentity(*byPositions(mesh, mesh)));
}

TEST(FaceMatch, neighboursFindEveryOrderTurnAndCommonWinding)
{
    const TriangleMesh mesh = ragged();
    for (unsigned seed = 0; seed < 12; ++seed) {
        const Shuffled other =
            shuffled(mesh, seed, seed % 2 == 0 ? Winding::Kept : Winding::AllTurnedOver);
        const auto match = byNeighbours(mesh, other.mesh);
        ASSERT_TRUE(match.has_value()) << match.error().message;
        EXPECT_EQ(*match, other.match);
    }
}

TEST(FaceMatch, neighboursMatchMovedVerticesAndParts)
{
    // Two parts that differ, one of them wound the other way round, bent out of shape.
    TriangleMesh mesh = ragged();
    const TriangleMesh more = ragged(4);
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    mesh.positions.insert(mesh.positions.end(), more.positions.begin(), more.positions.end());
    for (const Triangle& t : more.triangles) {
        mesh.triangles.push_back({first + t[0], first + t[2], first + t[1]});
    }
    Shuffled other = shuffled(mesh, 5, Winding::Kept);
    for (glm::vec3& position : other.mesh.positions) {
        position += glm::vec3(3, position.y * position.x, 0);
    }
    EXPECT_FALSE(byPositions(mesh, other.mesh).has_value());
    const auto match = byNeighbours(mesh, other.mesh);
    ASSERT_TRUE(match.has_value()) << match.error().message;
    EXPECT_EQ(*match, other.match);
}

TEST(FaceMatch, digitsThatATextFileRoundsAwayDoNotMatter)
{
    const TriangleMesh mesh = ragged();
    Shuffled other = shuffled(mesh, 3, Winding::Random);
    std::mt19937 random(1);
    for (glm::vec3& position : other.mesh.positions) {
        position += 1e-6F * glm::vec3(random() % 3, random() % 3, random() % 3);
    }
    const auto match = byPositions(mesh, other.mesh);
    ASSERT_TRUE(match.has_value()) << match.error().message;
    EXPECT_EQ(*match, other.match);
    other.mesh.positions[7].x += 0.01F;
    EXPECT_THAT(byPositions(mesh, other.mesh).error().message, HasSubstr("no counterpart"));
}

TEST(FaceMatch, minusZeroIsZero)
{
    TriangleMesh mesh = test::octahedron();
    TriangleMesh other = mesh;
    for (glm::vec3& position : other.positions) {
        position *= -1.0F;
        position *= -1.0F;
        position.x = position.x == 0 ? -0.0F : position.x;
    }
    EXPECT_TRUE(isIdentity(*byPositions(mesh, other)));
}

TEST(FaceMatch, bothSidesOfASheetAreToldApartByTheirWinding)
{
    TriangleMesh mesh;
    mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    mesh.triangles = {{0, 1, 2}, {0, 2, 1}};
    TriangleMesh other = mesh;
    std::swap(other.triangles[0], other.triangles[1]);
    const auto match = byPositions(mesh, other);
    ASSERT_TRUE(match.has_value()) << match.error().message;
    EXPECT_EQ((*match)[0].face, FaceId{1});
    EXPECT_FALSE(turnsOver((*match)[0].corners));
    EXPECT_EQ((*match)[1].face, FaceId{0});
}

TEST(FaceMatch, facesThatNothingTellsApartAreRefused)
{
    TriangleMesh mesh;
    mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    mesh.triangles = {{0, 1, 2}, {1, 2, 0}};
    const auto match = byPositions(mesh, mesh);
    ASSERT_FALSE(match.has_value());
    EXPECT_THAT(match.error().message, HasSubstr("face 0 of the mesh has several counterparts"));
}

TEST(FaceMatch, aFaceWithoutExtentIsMatchedOnceAndOnlyTurned)
{
    TriangleMesh mesh = test::octahedron();
    mesh.positions.emplace_back(1, 0, 0);
    mesh.triangles.push_back({0, 6, 2});
    TriangleMesh other = mesh;
    std::ranges::rotate(other.triangles, other.triangles.end() - 1);
    const auto match = byPositions(mesh, other);
    ASSERT_TRUE(match.has_value()) << match.error().message;
    EXPECT_EQ(match->back(), MatchedFace{FaceId{0}});
}

TEST(FaceMatch, aSymmetricMeshHasNoOneMatchByNeighbours)
{
    for (const TriangleMesh& mesh :
         {test::icosahedron(), test::cube(), test::gridMesh(3), test::regularTetrahedron()}) {
        const auto match = byNeighbours(mesh, mesh);
        ASSERT_FALSE(match.has_value());
        EXPECT_THAT(match.error().message, HasSubstr("several counterparts"));
    }
}

TEST(FaceMatch, likePartsHaveNoOneMatchByNeighbours)
{
    TriangleMesh mesh = ragged();
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    const TriangleMesh copy = mesh;
    for (std::size_t k = 0; k < first; ++k) {
        mesh.positions.push_back(copy.positions[k] + glm::vec3(10, 0, 0));
    }
    for (const Triangle& t : copy.triangles) {
        mesh.triangles.push_back({first + t[0], first + t[1], first + t[2]});
    }
    EXPECT_THAT(byNeighbours(mesh, mesh).error().message, HasSubstr("several counterparts"));
    EXPECT_TRUE(byPositions(mesh, shuffled(mesh, 1, Winding::Random).mesh).has_value());
}

/// A ring wound twice covers one wound once face by face, but is not the same.
TEST(FaceMatch, aCoverOfAMeshIsNoMatch)
{
    const auto ring = [](std::uint32_t around, std::uint32_t first, std::vector<Triangle>& into) {
        for (std::uint32_t k = 0; k < around; ++k) {
            const std::uint32_t next = (k + 1) % around;
            into.push_back({first + 2 * k, first + 2 * next, first + 2 * k + 1});
            into.push_back({first + 2 * next, first + 2 * next + 1, first + 2 * k + 1});
        }
    };
    std::vector<Triangle> one;
    ring(16, 0, one);
    std::vector<Triangle> two;
    ring(8, 0, two);
    ring(8, 16, two);
    NoProgress progress;
    const auto match = matchByNeighbours(buildAdjacency(one), buildAdjacency(two), progress);
    ASSERT_FALSE(match.has_value());
    EXPECT_THAT(match.error().message, HasSubstr("no counterpart"));
}

TEST(FaceMatch, otherMeshesAreRefused)
{
    const TriangleMesh mesh = ragged();
    TriangleMesh fewer = mesh;
    fewer.triangles.pop_back();
    EXPECT_THAT(byPositions(mesh, fewer).error().message, HasSubstr("faces, the mesh"));
    EXPECT_THAT(byNeighbours(mesh, fewer).error().message, HasSubstr("faces, the mesh"));
    TriangleMesh other = test::gridMesh(6);
    other.triangles.resize(mesh.faceCount());
    EXPECT_THAT(byNeighbours(mesh, other).error().message, HasSubstr("do not neighbour"));
}

TEST(FaceMatch, aMeshThatClosesOtherwiseIsNoMatch)
{
    // About each face alone both look the same, however far one goes.
    NoProgress progress;
    const auto match =
        matchByNeighbours(buildAdjacency(torus(12, 0)), buildAdjacency(torus(12, 5)), progress);
    ASSERT_FALSE(match.has_value());
    EXPECT_THAT(match.error().message, HasSubstr("no counterpart"));
}

TEST(FaceMatch, facesThatMeetAcrossOtherEdgesAreNoMatch)
{
    // Two triangles back to back, and two whose edges meet in another order.
    Adjacency pillow(2);
    Adjacency twisted(2);
    for (const LocalEdge edge : kLocalEdges) {
        pillow.connect(FaceId{0}, edge, FaceId{1}, static_cast<LocalEdge>((3 - indexOf(edge)) % 3));
        twisted.connect(FaceId{0}, edge, FaceId{1}, edge);
    }
    NoProgress progress;
    const auto match = matchByNeighbours(pillow, twisted, progress);
    ASSERT_FALSE(match.has_value());
    EXPECT_THAT(match.error().message, HasSubstr("no counterpart"));
}

TEST(FaceMatch, aRegularMeshOfManyFacesIsAnsweredSoon)
{
    NoProgress progress;
    const Adjacency mesh = buildAdjacency(torus(64, 0));
    EXPECT_FALSE(matchByNeighbours(mesh, mesh, progress).has_value());
}

TEST(FaceMatch, matchingCanBeCancelled)
{
    const TriangleMesh mesh = ragged();
    CancelAfter positions(0);
    EXPECT_EQ(matchByPositions(mesh, mesh, positions).error().kind, ErrorKind::Cancelled);
    CancelAfter neighbours(2);
    EXPECT_EQ(matchByNeighbours(
                  buildAdjacency(mesh.triangles), buildAdjacency(mesh.triangles), neighbours)
                  .error()
                  .kind,
              ErrorKind::Cancelled);
}
