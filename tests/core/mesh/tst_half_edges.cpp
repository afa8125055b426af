// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/half_edges.h"
#include "tests/core/mesh/meshes.h"

#include <OpenMesh/Core/Mesh/TriConnectivity.hh>
#include <gmock/gmock.h>

namespace trixel {
namespace {

using Structure = OpenMesh::TriConnectivity;

HalfEdges halfEdgesOf(const TriangleMesh& mesh)
{
    return {mesh.triangles, mesh.positions.size(), buildAdjacency(mesh.triangles)};
}

OpenMesh::HalfedgeHandle halfEdge(const Structure& s, int face, std::size_t edge)
{
    auto h = s.halfedge_handle(OpenMesh::FaceHandle(face));
    for (std::size_t e = 0; e < edge; ++e) {
        h = s.next_halfedge_handle(h);
    }
    return h;
}

// next and prev undo each other, loops close, half-edges meet at vertices.
void expectWellFormed(const Structure& s)
{
    for (int h = 0; h < static_cast<int>(s.n_halfedges()); ++h) {
        const OpenMesh::HalfedgeHandle here(h);
        const auto next = s.next_halfedge_handle(here);
        ASSERT_TRUE(s.is_valid_handle(next));
        ASSERT_EQ(s.prev_halfedge_handle(next), here);
        ASSERT_EQ(s.from_vertex_handle(next), s.to_vertex_handle(here));
        ASSERT_EQ(s.face_handle(next), s.face_handle(here));
        ASSERT_FALSE(s.is_boundary(here) && s.is_boundary(s.opposite_halfedge_handle(here)));
    }
    for (int v = 0; v < static_cast<int>(s.n_vertices()); ++v) {
        const auto out = s.halfedge_handle(OpenMesh::VertexHandle(v));
        if (out.is_valid()) {
            ASSERT_EQ(s.from_vertex_handle(out).idx(), v);
        }
    }
}

void expectSameTriangles(const HalfEdges& halfEdges, const TriangleMesh& mesh)
{
    const Structure& s = halfEdges.structure();
    ASSERT_EQ(s.n_faces() + halfEdges.refusedFaces().size(), mesh.faceCount());
    for (std::size_t f = 0; f < mesh.faceCount(); ++f) {
        const auto face = halfEdges.structureFace(faceId(f));
        ASSERT_EQ(face.has_value(), std::ranges::count(halfEdges.refusedFaces(), faceId(f)) == 0);
        if (!face) {
            continue;
        }
        ASSERT_EQ(halfEdges.meshFace(*face), faceId(f));
        for (std::size_t e = 0; e < 3; ++e) {
            const auto h = halfEdge(s, *face, e);
            ASSERT_EQ(s.face_handle(h).idx(), *face);
            ASSERT_EQ(s.from_vertex_handle(h).idx(), static_cast<int>(mesh.triangles[f][e]));
        }
    }
}

void expectSameNeighbours(const HalfEdges& halfEdges, const Adjacency& adjacency)
{
    const Structure& s = halfEdges.structure();
    for (int face = 0; face < static_cast<int>(s.n_faces()); ++face) {
        for (const LocalEdge e : kLocalEdges) {
            const auto back = s.opposite_halfedge_handle(halfEdge(s, face, indexOf(e)));
            const auto other = adjacency.neighbour(halfEdges.meshFace(face), e);
            const auto otherFace = other ? halfEdges.structureFace(other->face) : std::nullopt;
            ASSERT_EQ(s.is_boundary(back), !otherFace);
            if (otherFace) {
                ASSERT_EQ(back, halfEdge(s, *otherFace, indexOf(other->edge)));
            }
        }
    }
}

// Going round a vertex meets every kept face of the vertex, once.
void expectCompleteRings(const HalfEdges& halfEdges, const TriangleMesh& mesh)
{
    const Structure& s = halfEdges.structure();
    std::vector<std::size_t> corners(mesh.positions.size(), 0);
    for (int face = 0; face < static_cast<int>(s.n_faces()); ++face) {
        for (const std::uint32_t v : mesh.triangles[indexOf(halfEdges.meshFace(face))]) {
            ++corners[v];
        }
    }
    for (int v = 0; v < static_cast<int>(corners.size()); ++v) {
        std::size_t met = 0;
        for (auto f = s.cvf_iter(OpenMesh::VertexHandle(v)); f.is_valid(); ++f) {
            ++met;
        }
        ASSERT_EQ(met, corners[static_cast<std::size_t>(v)]) << "vertex " << v;
    }
}

void expectFaithful(const TriangleMesh& mesh)
{
    const HalfEdges halfEdges = halfEdgesOf(mesh);
    expectWellFormed(halfEdges.structure());
    expectSameTriangles(halfEdges, mesh);
    expectSameNeighbours(halfEdges, buildAdjacency(mesh.triangles));
    expectCompleteRings(halfEdges, mesh);
}

TEST(HalfEdgesTest, agreeWithTheAdjacencyOnMessyMeshes)
{
    std::size_t refused = 0;
    for (unsigned seed = 0; seed < 300; ++seed) {
        SCOPED_TRACE(seed);
        const TriangleMesh mesh = test::messyMesh(4 + seed % 30, 2 + seed % 60, seed);
        ASSERT_NO_FATAL_FAILURE(expectFaithful(mesh));
        refused += halfEdgesOf(mesh).refusedFaces().size();
    }
    EXPECT_GT(refused, 100U);
}

TEST(HalfEdgesTest, agreeWithOpenMeshOwnConstructionOnACleanMesh)
{
    const TriangleMesh mesh = test::gridMesh(20);
    ASSERT_NO_FATAL_FAILURE(expectFaithful(mesh));
    const HalfEdges halfEdges = halfEdgesOf(mesh);
    EXPECT_TRUE(halfEdges.refusedFaces().empty());

    Structure own;
    for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
        own.new_vertex();
    }
    for (const Triangle& t : mesh.triangles) {
        ASSERT_TRUE(own.add_face(OpenMesh::VertexHandle(static_cast<int>(t[0])),
                                 OpenMesh::VertexHandle(static_cast<int>(t[1])),
                                 OpenMesh::VertexHandle(static_cast<int>(t[2])))
                        .is_valid());
    }
    const Structure& s = halfEdges.structure();
    ASSERT_EQ(s.n_edges(), own.n_edges());
    for (int v = 0; v < static_cast<int>(s.n_vertices()); ++v) {
        const OpenMesh::VertexHandle vertex(v);
        EXPECT_EQ(s.valence(vertex), own.valence(vertex));
        EXPECT_EQ(s.is_boundary(vertex), own.is_boundary(vertex));
    }
}

TEST(HalfEdgesTest, refuseFacesThatRepeatAVertex)
{
    TriangleMesh mesh = test::tetrahedron();
    mesh.triangles.insert(mesh.triangles.begin() + 1, {2, 2, 3});
    const HalfEdges halfEdges = halfEdgesOf(mesh);
    EXPECT_THAT(halfEdges.refusedFaces(), testing::ElementsAre(faceId(1)));
    EXPECT_EQ(halfEdges.structureFace(faceId(0)), 0);
    EXPECT_EQ(halfEdges.structureFace(faceId(1)), std::nullopt);
    EXPECT_EQ(halfEdges.structureFace(faceId(4)), 3);
    EXPECT_EQ(halfEdges.meshFace(3), faceId(4));
}

TEST(HalfEdgesTest, openClosedRingsThatMeetAtAVertex)
{
    TriangleMesh mesh = test::tetrahedron();
    mesh.positions.insert(mesh.positions.end(), {{-1, 0, 0}, {0, -1, 0}, {0, 0, -1}});
    test::addTetrahedron(mesh, {0, 4, 5, 6});
    EXPECT_THAT(halfEdgesOf(mesh).refusedFaces(), testing::ElementsAre(faceId(3), faceId(7)));
    expectFaithful(mesh);
}

TEST(HalfEdgesTest, keepAllFacesOfAnEdgeOfThreeAndOfFansThatTouch)
{
    TriangleMesh mesh;
    mesh.positions.resize(9);
    mesh.triangles = {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}, {0, 5, 6}, {0, 7, 8}};
    EXPECT_TRUE(halfEdgesOf(mesh).refusedFaces().empty());
    expectFaithful(mesh);
}

TEST(HalfEdgesTest, ofAHugeCrowdedFanTakeLinearTime)
{
    TriangleMesh mesh;
    const std::uint32_t faces = 300'000;
    mesh.positions.resize(2 * faces + 4);
    for (std::uint32_t f = 0; f < faces; ++f) { // all meet at vertex 0, none share an edge
        mesh.triangles.push_back({0, 1 + 2 * f, 2 + 2 * f});
    }
    test::addTetrahedron(mesh, {0, 2 * faces + 1, 2 * faces + 2, 2 * faces + 3});
    EXPECT_EQ(halfEdgesOf(mesh).refusedFaces().size(), 1U);
}

TEST(HalfEdgesTest, takeAtMost60BytesAFace)
{
    const TriangleMesh mesh = test::gridMesh(300);
    EXPECT_LE(halfEdgesOf(mesh).memoryBytes(), 60 * mesh.faceCount());
}

} // namespace
} // namespace trixel
