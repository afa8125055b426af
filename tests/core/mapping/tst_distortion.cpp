// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mapping/distortion.h"
#include "core/mapping/projection.h"
#include "core/mapping/sphere_mapping.h"
#include "core/mapping/uv_mapping.h"
#include "tests/core/test_meshes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace trixel {
namespace {

TEST(DistortionTest, aPlaneFacedSquarelyIsOnlyScaled)
{
    const TriangleMesh mesh = test::gridMesh(3);
    const ProjectionMapping mapping(
        mesh, planarProjection({0, 0, 1}, {2, 0, 0}, {0, 2, 0}).value(), nullptr);
    for (const MapStretch& one : cornerStretch(mapping, mesh, {512, 512}, Threads{2})) {
        EXPECT_NEAR(one.most, 256, 1e-2);
        EXPECT_NEAR(one.fewest, 256, 1e-2);
        EXPECT_NEAR(one.anisotropy(), 1, 1e-4);
    }
}

TEST(DistortionTest, aSlantedPlaneIsSmearedByItsCosine)
{
    TriangleMesh mesh = test::gridMesh(3);
    for (glm::vec3& p : mesh.positions) {
        p.z = p.x * std::sqrt(3.0F); // 60 degrees
    }
    const ProjectionMapping mapping(
        mesh, planarProjection({0, 0, 9}, {1, 0, 0}, {0, 1, 0}).value(), nullptr);
    const auto stretch = cornerStretch(mapping, mesh, {100, 100}, Threads{1});
    for (const MapStretch& one : stretch) {
        EXPECT_NEAR(one.most, 100, 1e-2);
        EXPECT_NEAR(one.fewest, 50, 1e-2);
        EXPECT_NEAR(one.anisotropy(), 2, 1e-4);
    }
    EXPECT_NEAR(medianDensity(stretch), 5000, 1);
}

TEST(DistortionTest, aSphereIsStretchedTowardsItsPoles)
{
    // By the cosine of latitude: 1 at the equator of an image twice as wide as high.
    const TriangleMesh mesh = test::sphereMesh(5);
    const SphereMapping mapping(mesh, {0, 0, 0}, glm::dmat3(1));
    for (std::uint32_t k = 0; k < mesh.faceCount(); k += 7) {
        const auto c = mesh.corners(faceId(k));
        const glm::dvec3 p = (glm::dvec3(c[0]) + glm::dvec3(c[1]) + glm::dvec3(c[2])) / 3.0;
        const double latitude = std::atan2(p.y, std::hypot(p.x, p.z));
        if (std::abs(latitude) > 1.2) {
            continue;
        }
        const MapStretch one =
            stretchAt(mapping, mesh, faceId(k), {1.0 / 3, 1.0 / 3}, {2000, 1000});
        EXPECT_NEAR(one.fewest, 1000 / std::numbers::pi, 8) << latitude;
        EXPECT_NEAR(one.anisotropy(), 1 / std::cos(latitude), 0.03 / std::cos(latitude));
    }
}

TEST(DistortionTest, whereNothingLandsAndWhereFacesHaveNoAreaThereIsNone)
{
    TriangleMesh mesh = test::gridMesh(1);
    mesh.triangles.push_back({0, 0, 1});
    const ProjectionMapping beside(
        mesh, planarProjection({5, 5, 1}, {1, 0, 0}, {0, 1, 0}).value(), nullptr);
    const auto stretch = cornerStretch(beside, mesh, {100, 100}, Threads{1});
    EXPECT_TRUE(std::isnan(stretch[0].most));
    EXPECT_TRUE(std::isnan(medianDensity(stretch)));
    const ProjectionMapping over(
        mesh, planarProjection({0, 0, 1}, {1, 0, 0}, {0, 1, 0}).value(), nullptr);
    EXPECT_TRUE(std::isnan(cornerStretch(over, mesh, {100, 100}, Threads{1})[6].most));
}

TEST(DistortionTest, uvsThatFoldOntoALineAreSmearedWithoutEnd)
{
    TriangleMesh mesh = test::gridMesh(1);
    mesh.cornerUvs = {{0, 0}, {0.5F, 0}, {1, 0}, {0, 0}, {1, 0}, {0, 1}};
    const MapStretch one = stretchAt(UvMapping(mesh), mesh, faceId(0), {0.2, 0.2}, {64, 64});
    EXPECT_EQ(one.fewest, 0);
    EXPECT_TRUE(std::isinf(one.anisotropy()));
}

} // namespace
} // namespace trixel
