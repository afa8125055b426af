// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/filter/flat_walk.h"
#include "core/filter/unfolding.h"
#include "core/study/test_scene.h"
#include "tests/core/filter/filter_scenes.h"
#include "tests/core/test_meshes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

using namespace trixel;
using namespace trixel::test;

namespace {

/// The face about its own centroid, `size` times as large as it is.
PlacedFace about(const FilterSurface& surface, FaceId face, double size)
{
    const FaceShape& shape = surface.shape(face);
    const glm::dvec2 centre = (shape.e1 + shape.e2) / 3.0;
    return {face, {size * -centre, size * (shape.e1 - centre), size * (shape.e2 - centre)}};
}

bool isLaid(const FilterSurface& surface, FaceId face, double size, double cut)
{
    return FlatWalk().lay(surface, about(surface, face, size), cut, SIZE_MAX).has_value();
}

} // namespace

TEST(FlatWalk, laysEveryFaceOfAFlatMeshOnce)
{
    const TriangleMesh mesh = gridMesh(20);
    const FilterSurface surface = surfaceOf(mesh);
    const FaceId hit = faceId(mesh.faceCount() / 2 + 21);
    FlatWalk walk;
    const auto all = walk.lay(surface, about(surface, hit, 1), 100, SIZE_MAX);
    ASSERT_TRUE(all);
    const std::vector<PlacedFace> laid(all->begin(), all->end());
    EXPECT_EQ(laid.front().face, hit);
    EXPECT_EQ(laid.size(), mesh.faceCount());
    std::set<FaceId> faces;
    for (const PlacedFace& place : laid) {
        EXPECT_TRUE(faces.insert(place.face).second);
        const auto corners = mesh.corners(place.face);
        for (std::size_t k = 0; k < 3; ++k) {
            const glm::vec3 own = corners[k] - mesh.corners(hit)[0];
            EXPECT_NEAR(glm::length(place.corners[k] - laid.front().corners[0]),
                        glm::length(glm::dvec3(own)),
                        1e-6);
        }
    }
    EXPECT_FALSE(walk.lay(surface, about(surface, hit, 1), 100, laid.size() - 1));
}

TEST(FlatWalk, leavesAVertexThatIsNotFlatToTheRule)
{
    const FilterSurface surface = surfaceOf(sphereMesh(2));
    for (std::uint32_t f = 0; f < surface.faceCount(); ++f) {
        const PlacedFace hit = about(surface, faceId(f), 1);
        double nearest = 1e9;
        for (const glm::dvec2 corner : hit.corners) {
            nearest = std::min(nearest, glm::length(corner));
        }
        EXPECT_TRUE(isLaid(surface, faceId(f), 1, 0.99 * nearest)) << "no vertex is reached";
        EXPECT_FALSE(isLaid(surface, faceId(f), 1, 1.01 * nearest)) << "one is";
    }
}

TEST(FlatWalk, leavesTheWayAroundToTheRule)
{
    // A plane that closes upon itself after eight edges: flat everywhere, but a face seen from both
    // sides would have two places.
    const FilterSurface surface = FilterSurface::equilateral(tileAdjacency());
    EXPECT_TRUE(isLaid(surface, faceId(3), 1, 2.5));
    EXPECT_FALSE(isLaid(surface, faceId(3), 1, 4.5));
    // The rule lays each once, also for a footprint that is long and narrow.
    const QueryEllipse round = [] {
        QueryEllipse ellipse;
        ellipse.centre = FaceShape{}.toPlane({0.3, 0.3});
        return ellipse;
    }();
    Unfolding unfolding;
    for (const glm::dvec2 sigmas : {glm::dvec2(3, 3), glm::dvec2(10, 0.1)}) {
        const EllipseFrame frame({0.8, 0.6}, sigmas.x, sigmas.y);
        std::set<FaceId> faces;
        for (const PlacedFace& place : unfolding.unfold(surface, faceId(3), round, frame, 3)) {
            EXPECT_TRUE(faces.insert(place.face).second);
        }
        EXPECT_GT(faces.size(), 30U);
    }
}

TEST(FlatWalk, leavesNeedlesToTheRule)
{
    TriangleMesh mesh = gridMesh(4);
    mesh.positions[12].y = mesh.positions[7].y + 1e-4F; // the middle one
    EXPECT_FALSE(isLaid(surfaceOf(mesh), faceId(0), 1, 10));
}
