// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/crease_angle.h"
#include "core/mesh/crease_edges.h"
#include "core/mesh/limit_surface.h"
#include "tests/core/mesh/cages.h"
#include "tests/core/mesh/meshes.h"

#include <glm/geometric.hpp>
#include <gmock/gmock.h>

namespace trixel {
namespace {

using namespace test;
using testing::ElementsAre;
using testing::IsEmpty;

std::shared_ptr<const Surface> surfaceOf(TriangleMesh mesh)
{
    NoProgress progress;
    return Surface::build(std::move(mesh), progress).value();
}

/// Two squares that meet along x = 0 at vertices 1 and 4, the second one tilted.
TriangleMesh folded(double degrees)
{
    const double angle = degrees * std::numbers::pi / 180;
    const auto x = static_cast<float>(std::cos(angle));
    const auto z = static_cast<float>(std::sin(angle));
    TriangleMesh mesh;
    mesh.positions = {{-1, 0, 0}, {0, 0, 0}, {x, 0, z}, {-1, 1, 0}, {0, 1, 0}, {x, 1, z}};
    mesh.triangles = {{0, 1, 4}, {0, 4, 3}, {1, 2, 5}, {1, 5, 4}};
    return mesh;
}

TEST(CreaseAngle, edgesFoldedByMoreAreCreasesWhicheverTheWay)
{
    for (const double fold : {20.0, -20.0, 90.0, 175.0}) {
        const auto surface = surfaceOf(folded(fold));
        EXPECT_THAT(creasesByAngle(*surface, std::abs(fold) - 0.01), ElementsAre(Crease{1, 4}));
        EXPECT_THAT(creasesByAngle(*surface, std::abs(fold) + 0.01), IsEmpty());
    }
}

TEST(CreaseAngle, aCubeHasTwelveAndNoDiagonals)
{
    const auto surface = surfaceOf(cube());
    const auto creases = creasesByAngle(*surface, 30);
    EXPECT_EQ(creases.size(), 12U);
    EXPECT_FALSE(firstOffEdges(surface->mesh(), creases));
    for (const Crease& crease : creases) {
        const auto& p = surface->mesh().positions;
        EXPECT_NEAR(glm::distance(p[crease.from], p[crease.to]), 2, 1e-6);
        EXPECT_LT(crease.from, crease.to);
    }
    EXPECT_THAT(creasesByAngle(*surface, 91), IsEmpty());
}

TEST(CreaseAngle, bordersAndFacesWithoutAreaHaveNone)
{
    TriangleMesh mesh = folded(90);
    mesh.positions.emplace_back(0, 0.5F, 0);
    mesh.triangles = {{0, 1, 4}, {0, 4, 3}, {1, 2, 5}, {1, 6, 4}}; // the last is a line
    EXPECT_THAT(creasesByAngle(*surfaceOf(mesh), 1), IsEmpty());
}

TEST(CreaseAngle, whatTheMeshSaysOfAnEdgeCounts)
{
    TriangleMesh mesh = folded(90);
    mesh.sharpness.creases = {{4, 1, 2.5F}, {1, 0, 1}};
    mesh.sharpness.vertices = {{3, 4}};
    const auto surface = surfaceOf(mesh);
    EXPECT_EQ(sharpnessOf(*surface, {}).creases.size(), 2U);
    const Sharpness with = sharpnessOf(*surface, 30.0F);
    EXPECT_EQ(with.creases.size(), 2U);
    EXPECT_THAT(with.creases, testing::Contains(Crease{4, 1, 2.5F}));
    EXPECT_EQ(with.vertices, mesh.sharpness.vertices);
}

} // namespace
} // namespace trixel
