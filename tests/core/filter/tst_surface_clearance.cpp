// SPDX-License-Identifier: GPL-3.0-or-later
//
// What walks over many faces know of a face: its apex, seen from every edge, and how far from it
// the nearest border is at least.
#include "core/filter/surface_walk.h"
#include "tests/core/filter/random_scene.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

using namespace trixel;
using namespace trixel::test;

namespace {

FilterSurface surfaceOf(const TriangleMesh& mesh)
{
    return FilterSurface::fromMesh(mesh, buildAdjacency(mesh.triangles));
}

} // namespace

TEST(LaneSteps, tellTheApexAsEveryEdgeSeesIt)
{
    Random random(5);
    const TriangleMesh mesh = randomClosedMesh(random);
    const FilterSurface surface = surfaceOf(mesh);
    for (std::size_t f = 0; f < mesh.faceCount(); ++f) {
        const FaceShape& shape = surface.shape(faceId(f));
        const std::array<glm::dvec2, 3> corners = {glm::dvec2(0), shape.e1, shape.e2};
        for (std::size_t e = 0; e < 3; ++e) {
            const glm::dvec2 along = corners[(e + 1) % 3] - corners[e];
            const glm::dvec2 z = surface.laneSteps(faceId(f)).opposite(e);
            const glm::dvec2 apex = corners[e] + z.x * along + z.y * glm::dvec2(-along.y, along.x);
            EXPECT_LE(glm::length(apex - corners[(e + 2) % 3]), 1e-12);
        }
    }
}

TEST(LaneSteps, promiseNoClearanceThatAStraightLineDoesNotHave)
{
    Random random(6);
    TriangleMesh mesh = flatLattice(12);
    for (glm::vec3& p : mesh.positions) {
        p.x += 0.3F * static_cast<float>(unit(random));
        p.y += 0.3F * static_cast<float>(unit(random));
    }
    const FilterSurface surface = surfaceOf(mesh);
    double farthest = 0;
    for (std::size_t f = 0; f < mesh.faceCount(); ++f) {
        const FaceId face = faceId(f);
        const FaceShape& shape = surface.shape(face);
        const double clearance = double(surface.laneSteps(face).clearance) * shape.e1.x;
        farthest = std::max(farthest, clearance);
        for (int k = 0; k < 50; ++k) {
            const double angle = 2 * std::numbers::pi * unit(random);
            const glm::dvec2 step(std::cos(angle), std::sin(angle));
            const SurfacePlace from{face, {0.4 * unit(random), 0.5 * unit(random)}};
            EXPECT_FALSE(walkStraight(surface, from, shape.toUv(clearance * step)).stopped);
        }
    }
    EXPECT_GE(farthest, 2.0) << "of an edge: so little would be no use";
}

TEST(LaneSteps, haveNoBorderToFearOnAClosedSurface)
{
    Random random(7);
    const TriangleMesh mesh = randomClosedMesh(random);
    const FilterSurface surface = surfaceOf(mesh);
    for (const FilterSurface::LaneSteps& steps : surface.laneSteps()) {
        EXPECT_TRUE(std::isinf(steps.clearance));
    }
}

TEST(LaneSteps, promiseNothingAboutAFaceWithoutArea)
{
    // Its shape was replaced, so that lengths change on the way over it.
    TriangleMesh mesh = flatLattice(12);
    constexpr std::size_t kMiddle = 156;
    const Triangle& flat = mesh.triangles[kMiddle];
    mesh.positions[flat[2]] = 0.5F * (mesh.positions[flat[0]] + mesh.positions[flat[1]]);
    const FilterSurface surface = surfaceOf(mesh);
    EXPECT_EQ(surface.laneSteps(faceId(kMiddle)).clearance, 0.0F);
}
