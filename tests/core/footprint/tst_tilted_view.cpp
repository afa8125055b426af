// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/footprint/tilted_view.h"
#include "core/mesh/triangle_mesh.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

namespace trixel {
namespace {

constexpr std::array<glm::vec3, 3> kCorners = {
    glm::vec3(1, 2, 3), glm::vec3(3, 2.5F, 3), glm::vec3(1.5F, 4, 4)};

FootprintEllipse ellipseFor(double degrees, const TiltedView& view)
{
    const PixelRay ray = tiltedRay(view, kCorners, {0.3, 0.3}, degrees);
    return ellipseOf(screenFootprint(ray, kCorners, 1e6), kCorners);
}

TEST(TiltedView, faceOnAPixelIsRound)
{
    const TiltedView view{5, 1e-3, {1, 0}};
    const FootprintEllipse ellipse = ellipseFor(0, view);
    EXPECT_NEAR(ellipse.majorLength, 0.5 * 5 * 1e-3, 1e-9);
    EXPECT_NEAR(ellipse.anisotropy(), 1, 1e-6);
}

TEST(TiltedView, anisotropyIsOneOverTheCosine)
{
    const TiltedView view{5, 1e-5, {0.3, 0.7}};
    for (const double degrees : {10.0, 45.0, 60.0, 80.0, 89.0}) {
        EXPECT_NEAR(ellipseFor(degrees, view).anisotropy() *
                        std::cos(degrees * std::numbers::pi / 180),
                    1,
                    1e-3)
            << degrees;
    }
}

TEST(TiltedView, longAxisLiesWhereTheEyeLeans)
{
    const TiltedView view{5, 1e-5, {0.3, 0.7}};
    const FootprintEllipse ellipse = ellipseFor(70, view);
    const glm::dvec2 along = glm::normalize(ellipse.major);
    const glm::dvec2 lean = glm::normalize(view.towards);
    EXPECT_NEAR(std::abs(along.x * lean.y - along.y * lean.x), 0, 1e-3);
}

TEST(TiltedView, seesThePointFromEveryAngleAndStaysFinite)
{
    const TiltedView view{5, 1e-3, {0.3, 0.7}};
    for (double degrees = -20; degrees < 120; degrees += 7) {
        const PixelRay ray = tiltedRay(view, kCorners, {0.3, 0.3}, degrees);
        const glm::dvec3 met = ray.origin + view.distance * ray.direction;
        const glm::dvec3 point(pointAt(kCorners, 0.3F, 0.3F));
        EXPECT_NEAR(glm::distance(met, point), 0, 1e-5);
        const Footprint footprint = screenFootprint(ray, kCorners);
        EXPECT_TRUE(std::isfinite(glm::length(footprint.w1) + glm::length(footprint.w2)));
    }
}

} // namespace
} // namespace trixel
