// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/mesh_report.h"
#include "core/mesh/surface.h"
#include "tests/core/mesh/meshes.h"

#include <gmock/gmock.h>
#include <set>

namespace trixel {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

MeshReport reportOf(const TriangleMesh& mesh)
{
    return inspectMesh(mesh, buildAdjacency(mesh.triangles));
}

TEST(MeshReportTest, closedMeshIsClean)
{
    const MeshReport report = reportOf(test::tetrahedron());
    EXPECT_EQ(report, MeshReport());
    EXPECT_TRUE(report.isClean());
    EXPECT_TRUE(report.describe().empty());
}

TEST(MeshReportTest, gridHasOnlyItsBorder)
{
    const MeshReport report = reportOf(test::gridMesh(10));
    EXPECT_TRUE(report.isClean());
    EXPECT_EQ(report.borderEdges, 40U);
    EXPECT_THAT(report.describe(), ElementsAre("40 border edges of one face"));
}

TEST(MeshReportTest, flippedPatchIsNamedWhollyAndTheRestIsNot)
{
    TriangleMesh mesh = test::gridMesh(10);
    for (const std::size_t face : {44U, 45U, 46U, 47U}) {
        std::swap(mesh.triangles[face][0], mesh.triangles[face][1]);
    }
    EXPECT_THAT(reportOf(mesh).flippedFaces,
                ElementsAre(faceId(44), faceId(45), faceId(46), faceId(47)));
    for (Triangle& t : mesh.triangles) { // the rest becomes the minority's enemy, not the minority
        std::swap(t[0], t[1]);
    }
    EXPECT_EQ(reportOf(mesh).flippedFaces.size(), 4U);
}

TEST(MeshReportTest, moebiusStripHasNoFlippedFaces)
{
    TriangleMesh mesh;
    const std::uint32_t n = 8;
    mesh.positions = test::messyMesh(2 * n, 0, 1).positions;
    for (std::uint32_t i = 0; i < n; ++i) {
        const bool seam = i + 1 == n;
        const std::uint32_t a = 2 * i;
        const std::uint32_t b = 2 * i + 1;
        const std::uint32_t c = seam ? 1 : a + 2;
        const std::uint32_t d = seam ? 0 : b + 2;
        mesh.triangles.push_back({a, c, b});
        mesh.triangles.push_back({b, c, d});
    }
    EXPECT_TRUE(reportOf(mesh).flippedFaces.empty());
}

TEST(MeshReportTest, duplicatesAreNamedFromTheSecondOn)
{
    TriangleMesh mesh = test::tetrahedron();
    mesh.triangles.push_back({3, 2, 1}); // faces of the tetrahedron, turned and reversed
    mesh.triangles.push_back(mesh.triangles[2]);
    mesh.triangles.push_back({1, 1, 2});
    mesh.triangles.push_back({2, 1, 2});
    EXPECT_THAT(reportOf(mesh).duplicateFaces, ElementsAre(faceId(4), faceId(5)));

    TriangleMesh pillow;
    pillow.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    pillow.triangles = {{0, 1, 2}, {0, 2, 1}};
    EXPECT_THAT(reportOf(pillow).duplicateFaces, ElementsAre(faceId(1)));
}

TEST(MeshReportTest, duplicatesAreThoseOfTheDefinitionOnMessyMeshes)
{
    for (unsigned seed = 0; seed < 100; ++seed) {
        const TriangleMesh mesh = test::messyMesh(5, 30, seed);
        std::set<Triangle> seen;
        std::vector<FaceId> expected;
        for (std::size_t f = 0; f < mesh.faceCount(); ++f) {
            Triangle t = mesh.triangles[f];
            std::sort(t.begin(), t.end());
            if (!seen.insert(t).second && !repeatsVertex(t)) {
                expected.push_back(faceId(f));
            }
        }
        ASSERT_EQ(reportOf(mesh).duplicateFaces, expected) << seed;
    }
}

TEST(MeshReportTest, facesWithoutAreaAreDegenerate)
{
    TriangleMesh mesh;
    mesh.positions = {{0, 0, 0},
                      {1, 0, 0},
                      {2, 0, 0},
                      {0, 1, 0},
                      {1, 0, 0},
                      {0.1F, 0.1F, 0.7F},
                      {0.2F, 0.2F, 1.4F},
                      {0.3F, 0.3F, 2.1F},
                      {1e-30F, 0, 0},
                      {0, 1e-30F, 0},
                      {3e38F, 0, 0},
                      {0, 3e38F, 0}};
    mesh.triangles = {
        {0, 1, 3}, {0, 1, 2}, {1, 4, 3}, {0, 1, 1}, {5, 6, 7}, {0, 8, 9}, {0, 10, 11}};
    EXPECT_THAT(reportOf(mesh).degenerateFaces,
                ElementsAre(faceId(1), faceId(2), faceId(3), faceId(4)));
}

TEST(MeshReportTest, descriptionNamesCountFirstFacesAndCost)
{
    MeshReport report;
    for (std::size_t f = 3; f < 12; ++f) {
        report.degenerateFaces.push_back(faceId(f));
    }
    report.isolatedFaces = {faceId(7)};
    report.nonManifoldEdges = {{faceId(1), LocalEdge::E2}};
    EXPECT_FALSE(report.isClean());
    EXPECT_THAT(report.describe(),
                ElementsAre(HasSubstr("1 side of a face on edges that do not join exactly two"),
                            HasSubstr("9 degenerate faces (faces 3, 4, 5, 6, 7, …): "),
                            HasSubstr("1 isolated face (face 7): ")));
}

TEST(SurfaceTest, bundlesWhatBelongsToAMesh)
{
    TriangleMesh mesh = test::tetrahedron();
    mesh.triangles.push_back({0, 0, 1});
    NoProgress progress;
    const auto surface = Surface::build(mesh, progress);
    ASSERT_TRUE(surface);
    const Surface& s = **surface;
    EXPECT_EQ(s.mesh().triangles, mesh.triangles);
    EXPECT_EQ(s.adjacency(), buildAdjacency(mesh.triangles));
    EXPECT_THAT(s.report().halfEdgeRefusedFaces, ElementsAre(faceId(4)));
    EXPECT_EQ(s.low(), glm::vec3(0));
    EXPECT_EQ(s.high(), glm::vec3(1));
    EXPECT_FLOAT_EQ(s.size(), std::sqrt(3.0F));
    const auto hit = s.bvh().raycast({{0.2F, 0.2F, -1}, {0, 0, 1}});
    ASSERT_TRUE(hit);
    EXPECT_EQ(hit->face, faceId(0));
}

TEST(SurfaceTest, cancelledBuildGivesNothing)
{
    class CancelAfter final : public Progress
    {
    public:
        explicit CancelAfter(int reports)
            : m_left(reports)
        {
        }
        bool report(double /*fraction*/) override { return m_left-- > 0; }

    private:
        int m_left;
    };
    for (int reports = 0; reports < 5; ++reports) {
        CancelAfter progress(reports);
        const auto surface = Surface::build(test::tetrahedron(), progress);
        ASSERT_FALSE(surface);
        EXPECT_EQ(surface.error().kind, ErrorKind::Cancelled);
    }
}

} // namespace
} // namespace trixel
