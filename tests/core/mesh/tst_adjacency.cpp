// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/adjacency.h"
#include "tests/core/mesh/meshes.h"

#include <gmock/gmock.h>

namespace trixel {
namespace {

// The definition, by looking at every pair of faces.
Adjacency adjacencyBySearch(const std::vector<Triangle>& triangles)
{
    Adjacency adjacency(triangles.size());
    for (std::size_t f = 0; f < triangles.size(); ++f) {
        for (const LocalEdge e : kLocalEdges) {
            if (repeatsVertex(triangles[f])) {
                continue;
            }
            const std::uint32_t from = triangles[f][indexOf(e)];
            const std::uint32_t to = triangles[f][(indexOf(e) + 1) % 3];
            int sharing = 0;
            std::optional<EdgeNeighbour> opposite;
            for (std::size_t g = 0; g < triangles.size(); ++g) {
                for (const LocalEdge k : kLocalEdges) {
                    const std::uint32_t a = triangles[g][indexOf(k)];
                    const std::uint32_t b = triangles[g][(indexOf(k) + 1) % 3];
                    if (g == f || repeatsVertex(triangles[g])) {
                        continue;
                    }
                    sharing += (a == from && b == to) || (a == to && b == from) ? 1 : 0;
                    if (a == to && b == from) {
                        opposite = EdgeNeighbour{faceId(g), k};
                    }
                }
            }
            if (sharing == 1 && opposite) {
                adjacency.connect(faceId(f), e, opposite->face, opposite->edge);
            }
        }
    }
    return adjacency;
}

TEST(AdjacencyTest, equalsSearchOverAllPairsOnMessyMeshes)
{
    std::size_t joined = 0;
    for (unsigned seed = 0; seed < 200; ++seed) {
        const TriangleMesh mesh = test::messyMesh(5 + seed % 20, 3 + seed % 40, seed);
        const Adjacency adjacency = buildAdjacency(mesh.triangles);
        ASSERT_EQ(adjacency, adjacencyBySearch(mesh.triangles)) << "seed " << seed;
        for (std::size_t f = 0; f < mesh.faceCount(); ++f) {
            joined += adjacency.neighbour(faceId(f), LocalEdge::E0) ? 1 : 0;
        }
    }
    EXPECT_GT(joined, 100U); // the meshes did have neighbours
}

TEST(AdjacencyTest, isSymmetric)
{
    const TriangleMesh mesh = test::gridMesh(300);
    const Adjacency adjacency = buildAdjacency(mesh.triangles);
    std::size_t borders = 0;
    for (std::size_t f = 0; f < mesh.faceCount(); ++f) {
        for (const LocalEdge e : kLocalEdges) {
            const auto other = adjacency.neighbour(faceId(f), e);
            borders += other ? 0 : 1;
            if (other) {
                ASSERT_EQ(adjacency.neighbour(other->face, other->edge),
                          (EdgeNeighbour{faceId(f), e}));
            }
        }
    }
    EXPECT_EQ(borders, 4U * 300U);
}

TEST(AdjacencyTest, namesTheEdgeTheNeighbourGivesTheSharedEdge)
{
    // Shared edge 1–2: E1 of the first, E2 of the second.
    const Adjacency adjacency = buildAdjacency(std::vector<Triangle>{{0, 1, 2}, {1, 3, 2}});
    EXPECT_EQ(adjacency.neighbour(faceId(0), LocalEdge::E1),
              (EdgeNeighbour{faceId(1), LocalEdge::E2}));
    EXPECT_EQ(adjacency.neighbour(faceId(0), LocalEdge::E0), std::nullopt);
}

TEST(AdjacencyTest, edgeOfThreeFacesIsABorder)
{
    const Adjacency adjacency =
        buildAdjacency(std::vector<Triangle>{{0, 1, 2}, {1, 0, 3}, {0, 1, 4}});
    for (std::size_t f = 0; f < 3; ++f) {
        EXPECT_EQ(adjacency.neighbour(faceId(f), LocalEdge::E0), std::nullopt);
    }
}

TEST(AdjacencyTest, edgeRunTheSameWayByBothFacesIsABorder)
{
    const Adjacency adjacency = buildAdjacency(std::vector<Triangle>{{0, 1, 2}, {0, 1, 3}});
    EXPECT_EQ(adjacency.neighbour(faceId(0), LocalEdge::E0), std::nullopt);
}

TEST(AdjacencyTest, faceThatRepeatsAVertexDoesNotComeBetweenItsNeighbours)
{
    const Adjacency adjacency =
        buildAdjacency(std::vector<Triangle>{{0, 1, 2}, {0, 1, 1}, {1, 0, 3}});
    EXPECT_EQ(adjacency.neighbour(faceId(0), LocalEdge::E0),
              (EdgeNeighbour{faceId(2), LocalEdge::E0}));
    EXPECT_EQ(adjacency.neighbour(faceId(1), LocalEdge::E0), std::nullopt);
}

TEST(AdjacencyTest, hugeFanIsJoinedAllAround)
{
    const std::uint32_t faces = 200'000;
    std::vector<Triangle> fan;
    for (std::uint32_t f = 0; f < faces; ++f) {
        fan.push_back({0, 1 + f, 1 + (f + 1) % faces});
    }
    const Adjacency adjacency = buildAdjacency(fan);
    for (std::uint32_t f = 0; f < faces; ++f) {
        ASSERT_EQ(adjacency.neighbour(faceId(f), LocalEdge::E2),
                  (EdgeNeighbour{faceId((f + 1) % faces), LocalEdge::E0}))
            << f;
    }
}

TEST(AdjacencyTest, noFacesHaveNoNeighbours)
{
    EXPECT_EQ(buildAdjacency({}).faceCount(), 0U);
}

} // namespace
} // namespace trixel
