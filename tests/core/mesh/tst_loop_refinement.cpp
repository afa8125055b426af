// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/loop_refinement.h"
#include "tests/core/mesh/cages.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <gmock/gmock.h>
#include <limits>
#include <map>
#include <numbers>
#include <utility>

namespace trixel {
namespace {

using testing::HasSubstr;

using namespace test;

/// Times each edge is run along, in each direction.
std::map<std::pair<std::uint32_t, std::uint32_t>, int> directedEdges(const TriangleMesh& mesh)
{
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
    for (const Triangle& t : mesh.triangles) {
        for (std::size_t e = 0; e < 3; ++e) {
            ++edges[{t[e], t[(e + 1) % 3]}];
        }
    }
    return edges;
}

std::size_t borderEdges(const TriangleMesh& mesh)
{
    const auto edges = directedEdges(mesh);
    std::size_t borders = 0;
    for (const auto& [edge, times] : edges) {
        EXPECT_EQ(times, 1);
        borders += edges.contains({edge.second, edge.first}) ? 0U : 1U;
    }
    return borders;
}

/// The limit of a vertex amid `n` neighbours: a blend of it with their mean (Loop 1987;
/// Schweitzer).
glm::vec3 limitOf(glm::vec3 vertex, const std::vector<glm::vec3>& ring)
{
    const double n = static_cast<double>(ring.size());
    const double c = 0.375 + 0.25 * std::cos(2 * std::numbers::pi / n);
    const double beta = (0.625 - c * c) / n;
    const double share = 1 / (n + 3 / (8 * beta));
    glm::vec3 sum(0);
    for (const glm::vec3& p : ring) {
        sum += p;
    }
    return static_cast<float>(1 - n * share) * vertex + static_cast<float>(share) * sum;
}

void expectNear(glm::vec3 found, glm::vec3 expected)
{
    EXPECT_LT(glm::distance(found, expected), 1e-6F);
}

TEST(LoopRefinement, everyStepQuartersTheFacesOfClosedMeshesAndKeepsThemClosed)
{
    for (const TriangleMesh& cage : {regularTetrahedron(), octahedron(), icosahedron()}) {
        std::size_t faces = cage.faceCount();
        for (int steps = 0; steps <= 4; ++steps, faces *= 4) {
            const Result<TriangleMesh> mesh = loopRefined(cage, steps);
            ASSERT_TRUE(mesh);
            EXPECT_EQ(mesh->faceCount(), faces);
            EXPECT_EQ(mesh->positions.size(), faces / 2 + 2); // Euler: V - E + F = 2
            EXPECT_EQ(borderEdges(*mesh), 0U);
        }
    }
}

TEST(LoopRefinement, facesKeepTheirOrientation)
{
    const Result<TriangleMesh> mesh = loopRefined(icosahedron(), 3);
    ASSERT_TRUE(mesh);
    for (std::size_t f = 0; f < mesh->faceCount(); ++f) {
        const auto c = mesh->corners(faceId(f));
        const glm::vec3 normal = glm::cross(c[1] - c[0], c[2] - c[0]);
        EXPECT_GT(glm::dot(normal, c[0] + c[1] + c[2]), 0);
    }
}

TEST(LoopRefinement, facesFollowTheirCageFaceInItsOrder)
{
    const TriangleMesh cage = hexagon(0);
    const Result<TriangleMesh> mesh = loopRefined(cage, 2);
    ASSERT_TRUE(mesh);
    ASSERT_EQ(mesh->sourceFaces.size(), mesh->faceCount());
    for (std::size_t f = 0; f < mesh->faceCount(); ++f) {
        EXPECT_EQ(mesh->sourceFaces[f], f / 16);
        // A flat hexagon keeps each refined face in the sector of its cage face.
        const auto c = mesh->corners(faceId(f));
        const glm::vec3 centre = c[0] + c[1] + c[2];
        const double turn = std::atan2(centre.y, centre.x) / (2 * std::numbers::pi);
        EXPECT_EQ(static_cast<std::size_t>(6 * (turn < 0 ? turn + 1 : turn)), f / 16);
    }
}

TEST(LoopRefinement, verticesOfRegularSolidsReachTheirLimit)
{
    for (const TriangleMesh& cage : {regularTetrahedron(), octahedron(), icosahedron()}) {
        const auto edges = directedEdges(cage);
        for (int steps : {0, 1, 3}) {
            const Result<TriangleMesh> mesh = loopRefined(cage, steps);
            ASSERT_TRUE(mesh);
            for (std::uint32_t v = 0; v < cage.positions.size(); ++v) {
                std::vector<glm::vec3> ring;
                for (const auto& [edge, times] : edges) {
                    if (edge.first == v) {
                        ring.push_back(cage.positions[edge.second]);
                    }
                }
                const glm::vec3 limit = limitOf(cage.positions[v], ring);
                float nearest = std::numeric_limits<float>::max();
                for (const glm::vec3& p : mesh->positions) {
                    nearest = std::min(nearest, glm::distance(p, limit));
                }
                EXPECT_LT(nearest, 1e-6F);
            }
        }
    }
}

TEST(LoopRefinement, aBumpFlattensToHalfItsHeightAtARegularVertex)
{
    const Result<TriangleMesh> mesh = loopRefined(hexagon(1), 0);
    ASSERT_TRUE(mesh);
    expectNear(mesh->positions[0], {0, 0, 0.5F});
}

TEST(LoopRefinement, bordersFollowTheCubicCurveOfTheirVerticesAlone)
{
    const TriangleMesh low = hexagon(0);
    for (const float height : {0.0F, 5.0F}) {
        const Result<TriangleMesh> mesh = loopRefined(hexagon(height), 0);
        ASSERT_TRUE(mesh);
        for (std::size_t k = 0; k < 6; ++k) {
            const glm::vec3 before = low.positions[1 + (k + 5) % 6];
            const glm::vec3 at = low.positions[1 + k];
            const glm::vec3 after = low.positions[1 + (k + 1) % 6];
            expectNear(mesh->positions[1 + k], (before + 4.0F * at + after) / 6.0F);
        }
        EXPECT_EQ(borderEdges(loopRefined(hexagon(height), 3).value()), 6U * 8U);
    }
}

TEST(LoopRefinement, aLoneTriangleKeepsItsCorners)
{
    TriangleMesh cage;
    cage.positions = {{0, 0, 0}, {2, 0, 0}, {0, 3, 0}};
    cage.triangles = {{0, 1, 2}};
    const Result<TriangleMesh> mesh = loopRefined(cage, 2);
    ASSERT_TRUE(mesh);
    EXPECT_EQ(mesh->faceCount(), 16U);
    for (const glm::vec3& corner : cage.positions) {
        EXPECT_THAT(mesh->positions, testing::Contains(corner));
    }
}

TEST(LoopRefinement, theSameCageGivesTheSameBits)
{
    const Result<TriangleMesh> a = loopRefined(icosahedron(), 3);
    const Result<TriangleMesh> b = loopRefined(icosahedron(), 3);
    ASSERT_TRUE(a && b);
    EXPECT_EQ(a->positions, b->positions);
    EXPECT_EQ(a->triangles, b->triangles);
}

TEST(LoopRefinement, threeFacesOnAnEdgeAreRefinedAllTheSame)
{
    TriangleMesh cage;
    cage.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}};
    cage.triangles = {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}};
    const Result<TriangleMesh> mesh = loopRefined(cage, 2);
    ASSERT_TRUE(mesh);
    EXPECT_EQ(mesh->faceCount(), 48U);
}

TEST(LoopRefinement, verticesOfNoFaceAreKept)
{
    TriangleMesh cage = regularTetrahedron();
    cage.positions.insert(cage.positions.begin(), glm::vec3(9, 9, 9));
    for (Triangle& t : cage.triangles) {
        t = {t[0] + 1, t[1] + 1, t[2] + 1};
    }
    const Result<TriangleMesh> mesh = loopRefined(cage, 2);
    ASSERT_TRUE(mesh);
    EXPECT_EQ(mesh->faceCount(), 64U);
    EXPECT_THAT(mesh->positions, testing::Contains(glm::vec3(9, 9, 9)));
}

std::string refusal(const TriangleMesh& cage, int steps)
{
    const Result<TriangleMesh> mesh = loopRefined(cage, steps);
    return mesh ? "refined" : mesh.error().message;
}

TEST(LoopRefinement, refusesWhatCannotBeRefinedAndNamesIt)
{
    TriangleMesh beyond = regularTetrahedron();
    beyond.triangles[2][1] = 4;
    EXPECT_EQ(refusal(beyond, 1), "face 2 has vertex 4, the cage has 4");
    beyond.triangles[2][1] = 0xFFFFFFFF; // negative where the library reads it
    EXPECT_THAT(refusal(beyond, 1), HasSubstr("face 2 has vertex 4294967295"));

    TriangleMesh twice = regularTetrahedron();
    twice.triangles[1] = {3, 1, 3};
    EXPECT_THAT(refusal(twice, 1), HasSubstr("face 1 has a corner twice"));

    TriangleMesh infinite = regularTetrahedron();
    infinite.positions[3].y = std::numeric_limits<float>::infinity();
    EXPECT_THAT(refusal(infinite, 1), HasSubstr("vertex 3"));

    EXPECT_THAT(refusal(TriangleMesh{}, 1), HasSubstr("no faces"));
    EXPECT_THAT(refusal(regularTetrahedron(), -1), HasSubstr("0 to 8 steps, not -1"));
    EXPECT_THAT(refusal(regularTetrahedron(), 9), HasSubstr("0 to 8 steps, not 9"));
}

TEST(LoopRefinement, refusesFansAboveTheValenceCap)
{
    EXPECT_EQ(loopRefined(fan(256), 1)->faceCount(), 1024U);
    EXPECT_THAT(refusal(fan(257), 1), HasSubstr("vertex 0 has 257 faces around it, at most 256"));
}

TEST(LoopRefinement, refusesMoreFacesThanTheCap)
{
    TriangleMesh many = regularTetrahedron();
    many.triangles.resize(257, many.triangles[0]);
    EXPECT_THAT(refusal(many, 8), HasSubstr("up to 256 faces, this one has 257"));
}

} // namespace
} // namespace trixel
