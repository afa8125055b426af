// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/adjacency.h"
#include "core/mesh/limit_tessellation.h"
#include "render/filter_mesh.h"
#include "tests/core/mesh/cages.h"
#include "tests/core/mesh/meshes.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

namespace trixel::render {
namespace {

TexelStore storeFor(const TriangleMesh& mesh, int level = 3)
{
    return TexelStore(static_cast<std::uint32_t>(mesh.faceCount()),
                      TexelFormat{},
                      Level(level),
                      std::vector<std::byte>(3));
}

std::shared_ptr<const LimitTessellation> limitOf(const TriangleMesh& mesh, double error)
{
    NoProgress progress;
    const auto bends =
        LimitBends::measure(LimitSurface::build(mesh).value(), Threads{1}, progress).value();
    return LimitTessellation::make(
               bends, {ErrorScale::ofWorld(), error}, nullptr, Threads{1}, progress)
        .value();
}

TEST(FilterMesh, onTheLimitEdgesAreAsLongAsTheyAreThere)
{
    const TriangleMesh ball = test::icosahedron();
    const auto limit = limitOf(ball, 1e-5);
    const FilterMesh mesh(ball, buildAdjacency(ball.triangles), storeFor(ball), limit.get());
    double arc = 0; // all edges are alike
    glm::dvec3 before(limit->surface().at(faceId(0), {0, 0}).position);
    for (int k = 1; k <= 2000; ++k) {
        const glm::dvec3 next = limit->surface().at(faceId(0), {k / 2000.0, 0}).position;
        arc += glm::distance(before, next);
        before = next;
    }
    const double onCage = glm::distance(ball.positions[0], ball.positions[11]);
    EXPECT_LT(arc, 0.9 * onCage);
    for (const VertexScale& scale : mesh.scales()) {
        EXPECT_NEAR(scale.log2Length, std::log2(arc), 2e-3);
        EXPECT_NEAR(scale.log2Texel, std::log2(arc) - 3, 2e-3);
    }
}

TEST(FilterMesh, onALimitThatIsTheCageAllStaysTheSame)
{
    const TriangleMesh grid = test::gridMesh(8);
    const auto limit = limitOf(grid, 1e-3);
    const Adjacency adjacency = buildAdjacency(grid.triangles);
    const TexelStore store = storeFor(grid);
    const FilterMesh cage(grid, adjacency, store);
    const FilterMesh onLimit(grid, adjacency, store, limit.get());
    EXPECT_EQ(cage.across(), onLimit.across());
    int inside = 0;
    for (std::size_t v = 0; v < grid.positions.size(); ++v) {
        const glm::vec3 p = grid.positions[v];
        if (std::min(p.x, p.y) < 1.5F || std::max(p.x, p.y) > 6.5F) {
            continue; // the border is rounded off
        }
        ++inside;
        EXPECT_NEAR(cage.scales()[v].log2Length, onLimit.scales()[v].log2Length, 1e-5);
        EXPECT_EQ(cage.scales()[v].normal, onLimit.scales()[v].normal);
    }
    EXPECT_EQ(inside, 25);
}

} // namespace
} // namespace trixel::render
