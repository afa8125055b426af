// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/filter/surface_walk.h"
#include "tests/core/filter/filter_footprints.h"

#include <gtest/gtest.h>

#include <gmock/gmock.h>

namespace trixel::test {
namespace {

glm::dvec3 worldOf(const TriangleMesh& mesh, const SurfacePlace& place)
{
    const auto corners = mesh.corners(place.face);
    return glm::dvec3(corners[0]) + place.uv.x * glm::dvec3(corners[1] - corners[0]) +
           place.uv.y * glm::dvec3(corners[2] - corners[0]);
}

glm::dvec3 worldVector(const TriangleMesh& mesh, FaceId face, glm::dvec2 w)
{
    const auto corners = mesh.corners(face);
    return w.x * glm::dvec3(corners[1] - corners[0]) + w.y * glm::dvec3(corners[2] - corners[0]);
}

FilterSurface surfaceOf(const TriangleMesh& mesh)
{
    return FilterSurface::fromMesh(mesh, buildAdjacency(mesh.triangles));
}

TEST(SurfaceWalk, onAFlatIrregularMeshItIsAStraightLine)
{
    const TriangleMesh mesh = jittered(flatPatch(8), 0.2F, 5, true);
    const FilterSurface surface = surfaceOf(mesh);
    Dice dice(1);
    int inside = 0;
    for (int k = 0; k < 2000; ++k) {
        const SurfacePlace from{faceId(dice.below(mesh.faceCount())), randomPoint(dice)};
        const FaceShape& shape = surface.shape(from.face);
        const double angle = dice.between(0, 6.28);
        const double length = dice.between(0, 4);
        const glm::dvec2 step = shape.toUv(length * glm::dvec2(std::cos(angle), std::sin(angle)));
        const glm::dvec2 carried = shape.toUv({dice.uniform(), dice.uniform()});
        const SurfaceWalk walk = walkStraight(surface, from, step, {carried, -step});
        if (walk.stopped) {
            continue;
        }
        ++inside;
        const glm::dvec3 expected = worldOf(mesh, from) + worldVector(mesh, from.face, step);
        EXPECT_LT(glm::length(worldOf(mesh, walk.end) - expected), 1e-5);
        EXPECT_LT(glm::length(worldVector(mesh, walk.end.face, walk.carried[0]) -
                              worldVector(mesh, from.face, carried)),
                  1e-5);
    }
    EXPECT_GT(inside, 1000);
}

TEST(SurfaceWalk, theWayBackLeadsHome)
{
    for (std::uint32_t valence = 3; valence <= 10; ++valence) {
        const TriangleMesh mesh = closedIrregular(valence, valence);
        const FilterSurface surface = surfaceOf(mesh);
        Dice dice(valence);
        for (int k = 0; k < 300; ++k) {
            const SurfacePlace from{faceId(dice.below(mesh.faceCount())), randomPoint(dice)};
            const glm::dvec2 step(dice.between(-3, 3), dice.between(-3, 3));
            const SurfaceWalk there = walkStraight(surface, from, step, {glm::dvec2(0), step});
            EXPECT_FALSE(there.stopped);
            const SurfaceWalk back = walkStraight(surface, there.end, -there.carried[1]);
            EXPECT_EQ(back.end.face, from.face);
            EXPECT_LT(glm::length(back.end.uv - from.uv), 1e-5);
        }
    }
}

TEST(SurfaceWalk, alongAnEdgeItGoesOnWhicheverFaceRoundingPutsItIn)
{
    const TriangleMesh mesh = closedIrregular(7, 3);
    const FilterSurface surface = surfaceOf(mesh);
    for (std::uint32_t f = 0; f < mesh.faceCount(); ++f) {
        for (const LocalEdge edge : kLocalEdges) {
            // Leaves by the edge at once, and hardly.
            const SurfacePlace from{faceId(f), fromEdge(edge, {0.25, 0})};
            const SurfacePlace to{faceId(f), fromEdge(edge, {0.75, -1e-15})};
            const SurfaceWalk walk = walkStraight(surface, from, to.uv - from.uv);
            EXPECT_LT(glm::length(worldOf(mesh, walk.end) - worldOf(mesh, to)), 1e-5);
        }
    }
}

TEST(SurfaceWalk, stopsAtABorderOnTheLine)
{
    const TriangleMesh mesh = flatPatch(1);
    const FilterSurface surface = surfaceOf(mesh);
    const SurfaceWalk walk = walkStraight(surface, {faceId(0), {0.25, 0.25}}, {0.5, -0.5});
    EXPECT_TRUE(walk.stopped);
    EXPECT_EQ(walk.end.face, faceId(0));
    EXPECT_NEAR(walk.end.uv.x, 0.5, 1e-12);
    EXPECT_EQ(walk.end.uv.y, 0);
}

TEST(SurfaceWalk, endsInsideAFaceWhateverTheStep)
{
    // Through vertices, along edges, huge steps, and over faces without area.
    TriangleMesh mesh = closedIrregular(5, 2);
    mesh.positions[0] = mesh.positions[2];
    const FilterSurface surface = surfaceOf(mesh);
    Dice dice(9);
    for (int k = 0; k < 3000; ++k) {
        const std::array<glm::dvec2, 5> starts = {{{0, 0}, {1, 0}, {0, 1}, {0.5, 0.5}, {0.5, 0}}};
        const SurfacePlace from{faceId(dice.below(mesh.faceCount())), starts[dice.below(5)]};
        const double length = dice.logBetween(1e-12, 1e12);
        const glm::dvec2 way(dice.below(3) - 1.0, dice.below(3) - 1.0);
        const SurfaceWalk walk = walkStraight(surface, from, length * way);
        EXPECT_LT(indexOf(walk.end.face), mesh.faceCount());
        EXPECT_TRUE(walk.end.uv.x >= 0 && walk.end.uv.y >= 0 &&
                    walk.end.uv.x + walk.end.uv.y <= 1 + 1e-15)
            << walk.end.uv.x << " " << walk.end.uv.y;
    }
}

} // namespace
} // namespace trixel::test
