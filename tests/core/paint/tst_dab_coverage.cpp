// SPDX-License-Identifier: GPL-3.0-or-later
//
// What one dab covers, against brute force over every texel of the mesh.
#include "tests/core/paint/paint_fixture.h"
#include "tests/core/test_meshes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

using namespace trixel;
using test::coverageStore;
using test::surfaceOf;
using test::whiteBrush;

namespace {

FaceMap<Level> levelsOf(std::size_t faces, std::initializer_list<int> cycle)
{
    FaceMap<Level> levels(faces);
    for (std::size_t k = 0; k < faces; ++k) {
        levels[faceId(k)] = Level(std::data(cycle)[k % cycle.size()]);
    }
    return levels;
}

/// Paints one dab and compares every texel of every face with the falloff at its centroid.
/// \param takes  faces the dab may paint
std::size_t expectFalloffEverywhere(
    const std::shared_ptr<const Surface>& surface,
    const FaceMap<Level>& levels,
    const Brush& brush,
    const StrokeSample& sample,
    const std::function<bool(FaceId)>& takes = [](FaceId) { return true; })
{
    const TriangleMesh& mesh = surface->mesh();
    TexelStore store = coverageStore(levels);
    Stroke stroke(surface, brush, test::zeroFill(store));
    stroke.add(sample, store);
    const glm::dvec3 centre(pointAt(mesh.corners(sample.face), sample.uv.x, sample.uv.y));
    std::size_t covered = 0;
    std::size_t wrong = 0;
    test::forEachTexel(mesh, store, [&](FaceId face, TexelIndex texel, glm::dvec3 at) {
        const double distance = glm::length(at - centre) / brush.radius;
        const double expected = takes(face) ? brush.flow * brush.opacity *
                                                  test::falloffAt(distance, double{brush.hardness})
                                            : 0;
        const double found = test::valueAt(store, face, texel);
        const bool onTheRim = brush.hardness > 0.99F && std::abs(distance - 1) < 1e-5;
        wrong += !onTheRim && std::abs(found - expected) > 2e-5 ? 1 : 0;
        covered += expected > 0 ? 1 : 0;
    });
    EXPECT_EQ(wrong, 0U);
    return covered;
}

} // namespace

TEST(DabCoverage, aDabLargerThanTheFaceCoversEveryTexelAtEveryLevel)
{
    const auto surface = surfaceOf(test::gridMesh(1));
    for (int n = 0; n <= 7; ++n) {
        Brush brush = whiteBrush(3);
        brush.hardness = 1;
        const std::size_t covered =
            expectFalloffEverywhere(surface, levelsOf(2, {n}), brush, {faceId(0), {0.3F, 0.3F}});
        EXPECT_EQ(covered, 2U << (2 * n));
    }
}

TEST(DabCoverage, isTheFalloffAtTheCentroidAcrossFansOfMixedLevels)
{
    for (std::uint32_t valence = 3; valence <= 10; ++valence) {
        const auto surface = surfaceOf(test::fanMesh(valence));
        for (const float hardness : {0.0F, 0.5F, 1.0F}) {
            Brush brush = whiteBrush(0.4F);
            brush.hardness = hardness;
            brush.flow = 0.8F;
            brush.opacity = 0.9F;
            for (const glm::vec2 uv :
                 {glm::vec2(0, 0), glm::vec2(0.3F, 0), glm::vec2(0.1F, 0.2F)}) {
                const std::size_t covered = expectFalloffEverywhere(
                    surface, levelsOf(valence, {2, 6, 4}), brush, {faceId(1), uv});
                EXPECT_GT(covered, 500U);
            }
        }
    }
}

TEST(DabCoverage, runsOnOverAnEdgeBetweenACoarseAndAFineFaceOnCurvedSurfaces)
{
    const auto surface = surfaceOf(test::sphereMesh(2));
    const std::size_t faces = surface->mesh().faceCount();
    std::mt19937 random(3);
    std::uniform_real_distribution<float> part(0, 1);
    for (int k = 0; k < 10; ++k) {
        const float u = part(random);
        const FaceId face = faceId(random() % faces);
        expectFalloffEverywhere(surface,
                                levelsOf(faces, {2, 6, 0, 3}),
                                whiteBrush(0.05F + 0.4F * part(random)),
                                {face, {u, (1 - u) * part(random)}});
    }
}

TEST(DabCoverage, duplicateDegenerateAndNonManifoldFacesArePaintedAll)
{
    TriangleMesh mesh = test::gridMesh(3);
    const Triangle t = mesh.triangles[8];
    mesh.triangles.push_back(t);                   // a duplicate
    mesh.triangles.push_back({t[0], t[2], t[1]});  // another, the other way round
    mesh.triangles.push_back({t[0], t[1], t[1]});  // degenerate
    mesh.triangles.push_back({t[0], t[0], t[0]});  // a point
    mesh.positions.emplace_back(0.5F, 0.3F, 0.4F); // a fin on an edge
    mesh.triangles.push_back({t[0], t[1], static_cast<std::uint32_t>(mesh.positions.size() - 1)});
    const auto surface = surfaceOf(mesh);
    const std::size_t faces = surface->mesh().faceCount();
    expectFalloffEverywhere(
        surface, levelsOf(faces, {4, 3}), whiteBrush(0.5F), {faceId(8), {0.3F, 0.3F}});
}

TEST(DabCoverage, facesThatFaceAwayArePaintedOnlyThrough)
{
    // Two sheets a little apart, back to back.
    TriangleMesh mesh = test::gridMesh(2);
    const auto count = static_cast<std::uint32_t>(mesh.positions.size());
    const std::size_t front = mesh.triangles.size();
    for (std::uint32_t k = 0; k < count; ++k) {
        mesh.positions.push_back(mesh.positions[k] - glm::vec3(0, 0, 0.05F));
    }
    for (std::size_t k = 0; k < front; ++k) {
        const Triangle t = mesh.triangles[k];
        mesh.triangles.push_back({t[0] + count, t[2] + count, t[1] + count});
    }
    const auto surface = surfaceOf(mesh);
    Brush brush = whiteBrush(0.3F);
    const StrokeSample sample{faceId(0), {0.5F, 0.4F}};
    expectFalloffEverywhere(surface, levelsOf(2 * front, {4}), brush, sample, [&](FaceId face) {
        return indexOf(face) < front;
    });
    brush.paintThrough = true;
    expectFalloffEverywhere(surface, levelsOf(2 * front, {4}), brush, sample);
}

TEST(DabCoverage, aDabGoesRoundASharpConvexEdge)
{
    // A roof whose two sides meet at a right angle.
    TriangleMesh mesh;
    mesh.positions = {{0, 0, 1}, {0, 1, 1}, {-1, 0, 0}, {-1, 1, 0}, {1, 0, 0}, {1, 1, 0}};
    mesh.triangles = {{0, 1, 2}, {3, 2, 1}, {0, 4, 1}, {5, 1, 4}};
    const auto surface = surfaceOf(mesh);
    ASSERT_TRUE(surface->report().flippedFaces.empty());
    expectFalloffEverywhere(surface, levelsOf(4, {5}), whiteBrush(0.5F), {faceId(0), {0.5F, 0.1F}});
}

TEST(DabCoverage, facesWoundAgainstTheirNeighboursArePaintedLikeThem)
{
    TriangleMesh mesh = test::gridMesh(4);
    for (const std::size_t k : {9U, 12U, 20U}) {
        std::swap(mesh.triangles[k][1], mesh.triangles[k][2]);
    }
    const auto surface = surfaceOf(mesh);
    ASSERT_EQ(surface->report().flippedFaces.size(), 3U);
    const std::size_t faces = mesh.faceCount();
    expectFalloffEverywhere(
        surface, levelsOf(faces, {4}), whiteBrush(0.6F), {faceId(10), {0.3F, 0.3F}});
    // From a flipped face itself, too.
    expectFalloffEverywhere(
        surface, levelsOf(faces, {4}), whiteBrush(0.6F), {faceId(12), {0.3F, 0.3F}});
}
