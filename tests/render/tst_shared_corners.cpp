// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/mesh_reader.h"
#include "render/corner_normals.h"
#include "render/shared_corners.h"
#include "tests/bench/sheet_mesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>

using namespace trixel;
using namespace trixel::render;

namespace {

TriangleMesh meshOf(std::size_t vertices, std::vector<Triangle> triangles)
{
    return {std::vector<glm::vec3>(vertices), std::move(triangles), {}};
}

std::vector<std::uint32_t> sameNormals(const TriangleMesh& mesh)
{
    return std::vector<std::uint32_t>(3 * mesh.faceCount(), 7);
}

double cornersPerFace(const TriangleMesh& mesh, std::span<const std::uint32_t> normals)
{
    return static_cast<double>(SharedCorners::of(mesh, normals).corners.size()) /
           static_cast<double>(mesh.faceCount());
}

/// Of a face's corner, found by its label as the shader does.
const SharedCorner& cornerAt(const SharedCorners& shared, std::size_t face, int corner)
{
    const std::array<std::uint32_t, 3>& drawn = shared.faces[face];
    const std::uint32_t label = shared.corners[drawn[2]].labelAt(corner);
    return shared.corners[*std::ranges::find_if(
        drawn, [&](std::uint32_t c) { return shared.corners[c].label() == label; })];
}

/// Whether what is drawn of each face is its own three vertices with its normals, turned alike.
void expectSameMesh(const TriangleMesh& mesh, const std::vector<std::uint32_t>& normals)
{
    const SharedCorners shared = SharedCorners::of(mesh, normals);
    ASSERT_EQ(shared.faces.size(), mesh.faceCount());
    std::set<std::uint32_t> own;
    for (std::size_t f = 0; f < mesh.faceCount(); ++f) {
        const std::array<std::uint32_t, 3>& drawn = shared.faces[f];
        std::set<std::uint32_t> labels;
        Triangle vertices{};
        for (std::size_t k = 0; k < 3; ++k) {
            labels.insert(shared.corners[drawn[k]].label());
            vertices[k] = shared.corners[drawn[k]].vertex;
        }
        ASSERT_EQ(labels, (std::set<std::uint32_t>{0, 1, 2})) << f;
        ASSERT_EQ(shared.corners[drawn[2]].face(), f);
        ASSERT_TRUE(own.insert(drawn[2]).second) << f;
        const Triangle& triangle = mesh.triangles[f];
        const Triangle turned{triangle[1], triangle[2], triangle[0]};
        const Triangle again{triangle[2], triangle[0], triangle[1]};
        ASSERT_TRUE(vertices == triangle || vertices == turned || vertices == again) << f;
        for (int k = 0; k < 3; ++k) {
            const auto corner = static_cast<std::size_t>(k);
            ASSERT_EQ(cornerAt(shared, f, k).vertex, triangle[corner]) << f;
            ASSERT_EQ(cornerAt(shared, f, k).normal, normals[3 * f + corner]) << f;
        }
    }
}

void expectSameMesh(const TriangleMesh& mesh)
{
    expectSameMesh(mesh, sameNormals(mesh));
}

/// As a scan left it: its faces are in no good order.
TriangleMesh bunny()
{
    NoProgress silent;
    auto mesh = readMesh("/usr/share/glmark2/models/bunny.obj", silent);
    return mesh ? std::move(*mesh) : TriangleMesh();
}

} // namespace

TEST(SharedCorners, everyFaceIsDrawnAsItIs)
{
    const TriangleMesh sheet = sheetMesh(40);
    expectSameMesh(sheet);
    expectSameMesh(sheet, cornerNormals(sheet, 5));
    const TriangleMesh scan = bunny();
    ASSERT_GT(scan.faceCount(), 0U) << "needs Debian's glmark2-data";
    expectSameMesh(scan, cornerNormals(scan));
}

TEST(SharedCorners, everyFaceIsDrawnAsItIsWhereFacesMeetOddly)
{
    expectSameMesh(meshOf(3, {{0, 1, 2}}));
    expectSameMesh(meshOf(4, {{0, 1, 2}, {0, 3, 1}, {0, 2, 3}, {1, 3, 2}})); // closed
    expectSameMesh(meshOf(5, {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}}));            // three on an edge
    expectSameMesh(meshOf(3, {{0, 1, 2}, {0, 1, 2}, {2, 1, 0}, {1, 2, 0}, {0, 1, 2}})); // twice
    expectSameMesh(meshOf(7, {{0, 1, 2}, {0, 3, 4}, {0, 5, 6}}));            // one vertex
    expectSameMesh(meshOf(3, {{0, 0, 1}, {1, 1, 1}, {2, 1, 2}, {0, 1, 2}})); // without area
}

TEST(SharedCorners, everyFaceIsDrawnAsItIsInAnyMesh)
{
    std::mt19937 engine(5);
    const auto below = [&](std::size_t count) {
        return static_cast<std::uint32_t>(engine() % count);
    };
    for (int round = 0; round < 200; ++round) {
        const std::uint32_t vertices = 3 + below(8);
        TriangleMesh mesh = meshOf(vertices, {});
        std::vector<std::uint32_t> normals;
        for (int f = 0; f < 40; ++f) {
            mesh.triangles.push_back({below(vertices), below(vertices), below(vertices)});
            for (int k = 0; k < 3; ++k) {
                normals.push_back(below(2));
            }
        }
        expectSameMesh(mesh, normals);
    }
}

TEST(SharedCorners, smoothMeshesTakeAboutOneAFace)
{
    const TriangleMesh sheet = sheetMesh(100);
    EXPECT_LT(cornersPerFace(sheet, cornerNormals(sheet)), 1.05);
    const TriangleMesh scan = bunny();
    ASSERT_GT(scan.faceCount(), 0U) << "needs Debian's glmark2-data";
    EXPECT_LT(cornersPerFace(scan, cornerNormals(scan)), 1.15);
}

TEST(SharedCorners, whereEveryEdgeIsHardNothingIsShared)
{
    const TriangleMesh sheet = sheetMesh(10);
    std::vector<std::uint32_t> normals;
    for (std::size_t f = 0; f < sheet.faceCount(); ++f) {
        normals.insert(normals.end(), 3, static_cast<std::uint32_t>(f));
    }
    EXPECT_EQ(cornersPerFace(sheet, normals), 3);
}

TEST(SharedCorners, theSameMeshIsSharedTheSameWay)
{
    const TriangleMesh sheet = sheetMesh(30);
    EXPECT_EQ(SharedCorners::of(sheet, sameNormals(sheet)),
              SharedCorners::of(sheet, sameNormals(sheet)));
}

TEST(SharedCorners, ofNoMeshThereAreNone)
{
    EXPECT_TRUE(SharedCorners::of({}, {}).faces.empty());
}
