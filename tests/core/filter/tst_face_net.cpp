// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/filter/face_net.h"
#include "core/lattice/edge_transfer.h"
#include "tests/core/test_meshes.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <random>

using namespace trixel;
using namespace trixel::test;

namespace {

double doubleArea(const LaidFace& face)
{
    return face.layout().map().area();
}

void expectTrueLengths(const TriangleMesh& mesh, const LaidFace& laid)
{
    const auto corners = mesh.corners(laid.face);
    for (std::size_t k = 0; k < 3; ++k) {
        const double expected =
            glm::distance(glm::dvec3(corners[k]), glm::dvec3(corners[(k + 1) % 3]));
        EXPECT_NEAR(glm::distance(laid.corners[k], laid.corners[(k + 1) % 3]), expected, 1e-6);
    }
}

void expectSharedEdges(const FaceNet& net, const Adjacency& adjacency)
{
    for (const LocalEdge edge : kLocalEdges) {
        const auto neighbour = adjacency.neighbour(net.centre.face, edge);
        const auto& laid = net.across[indexOf(edge)];
        ASSERT_EQ(laid.has_value(), neighbour.has_value());
        if (!laid) {
            continue;
        }
        EXPECT_EQ(laid->face, neighbour->face);
        EXPECT_EQ(laid->corners[indexOf(neighbour->edge)],
                  net.centre.corners[indexOf(nextEdge(edge))]);
        EXPECT_EQ(laid->corners[indexOf(nextEdge(neighbour->edge))],
                  net.centre.corners[indexOf(edge)]);
        EXPECT_GT(doubleArea(*laid), 0);
    }
}

TriangleMesh bentMesh()
{
    TriangleMesh mesh = sphereMesh(1);
    std::mt19937 random(3);
    std::uniform_real_distribution<float> some(-0.2F, 0.2F);
    for (glm::vec3& p : mesh.positions) {
        p += glm::vec3(some(random), some(random), some(random));
    }
    return mesh;
}

} // namespace

TEST(FaceNet, facesKeepTheirTrueShapeAndMeetAtTheirEdges)
{
    const TriangleMesh mesh = bentMesh();
    const Adjacency adjacency = buildAdjacency(mesh.triangles);
    for (std::size_t k = 0; k < mesh.faceCount(); ++k) {
        const FaceNet net = layNet(mesh, adjacency, faceId(k));
        EXPECT_EQ(net.centre.corners[0], glm::dvec2(0));
        EXPECT_EQ(net.centre.corners[1].y, 0);
        EXPECT_GT(doubleArea(net.centre), 0);
        expectTrueLengths(mesh, net.centre);
        expectSharedEdges(net, adjacency);
        for (const auto& laid : net.across) {
            expectTrueLengths(mesh, *laid);
        }
    }
}

TEST(FaceNet, aNeighbourAsTheCentreStaysWhereItLay)
{
    const TriangleMesh mesh = bentMesh();
    const Adjacency adjacency = buildAdjacency(mesh.triangles);
    FaceNet net = layNet(mesh, adjacency, FaceId{5});
    for (int step = 0; step < 200; ++step) {
        const LaidFace next = *net.across[static_cast<std::size_t>(step) % 3];
        const LaidFace before = net.centre;
        net = layNet(mesh, adjacency, next);
        EXPECT_EQ(net.centre, next);
        expectSharedEdges(net, adjacency);
        // The way back leads to where it came from.
        bool found = false;
        for (const auto& laid : net.across) {
            if (laid->face == before.face) {
                found = glm::distance(laid->corners[0], before.corners[0]) < 1e-9;
            }
        }
        EXPECT_TRUE(found);
    }
}

TEST(FaceNet, flatNeighboursLieWhereTheyAre)
{
    const TriangleMesh mesh = gridMesh(4);
    const Adjacency adjacency = buildAdjacency(mesh.triangles);
    const FaceNet net = layNet(mesh, adjacency, faceId(10));
    // Ptex's own way across an edge is the unfolding of congruent faces.
    for (const LocalEdge edge : kLocalEdges) {
        const auto neighbour = adjacency.neighbour(net.centre.face, edge);
        const glm::dvec2 theirs(0.2, 0.3);
        const glm::dvec2 ours = acrossEdge(neighbour->edge, edge, theirs);
        EXPECT_LT(glm::distance(net.across[indexOf(edge)]->layout().map().point(theirs),
                                net.centre.layout().map().point(ours)),
                  1e-6);
    }
}

TEST(FaceNet, bordersHaveNothingAcross)
{
    const TriangleMesh mesh{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}, {}};
    const FaceNet net = layNet(mesh, buildAdjacency(mesh.triangles), FaceId{0});
    for (const auto& laid : net.across) {
        EXPECT_FALSE(laid);
    }
}

TEST(FaceNet, facesWithoutAreaAreLaidEquilateral)
{
    // A line, a point and a proper face that share edges by their vertex numbers.
    TriangleMesh mesh;
    mesh.positions = {{0, 0, 0}, {2, 0, 0}, {1, 0, 0}, {1, 1, 0}, {1, 1, 0}, {1, 1, 0}};
    mesh.triangles = {{0, 1, 2}, {1, 0, 3}, {3, 4, 5}};
    const Adjacency adjacency = buildAdjacency(mesh.triangles);
    const FaceNet line = layNet(mesh, adjacency, FaceId{0});
    EXPECT_NEAR(doubleArea(line.centre), 4 * 0.8660254037844386, 1e-9);
    expectSharedEdges(line, adjacency);
    const FaceNet proper = layNet(mesh, adjacency, FaceId{1});
    expectTrueLengths(mesh, proper.centre);
    expectSharedEdges(proper, adjacency);
    EXPECT_NEAR(doubleArea(*proper.across[0]), 4 * 0.8660254037844386, 1e-9);
    const FaceNet point = layNet(mesh, adjacency, FaceId{2});
    EXPECT_GT(doubleArea(point.centre), 0.1);
}

TEST(FaceNet, sizesOfFloatsFromEndToEndCanBeLaid)
{
    for (const float size : {1e-37F, 1e-20F, 1.0F, 1e18F, 1e37F}) {
        TriangleMesh mesh = gridMesh(2);
        for (glm::vec3& p : mesh.positions) {
            p *= size;
        }
        const Adjacency adjacency = buildAdjacency(mesh.triangles);
        const FaceNet net = layNet(mesh, adjacency, FaceId{3});
        EXPECT_GT(doubleArea(net.centre), 0);
        expectSharedEdges(net, adjacency);
    }
}
