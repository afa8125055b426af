// SPDX-License-Identifier: GPL-3.0-or-later
//
// Sphere map and bilinear quad, one test a row of the table of hazards.
#include "core/mapping/quad.h"
#include "core/mapping/sphere.h"
#include "tests/stability/hazard_row.h"

#include <glm/geometric.hpp>
#include <numbers>

namespace trixel::test {
namespace {

glm::dvec3 directionOf(double u, double v)
{
    const double longitude = (u - 0.25) * 2 * std::numbers::pi;
    const double latitude = (v - 0.5) * std::numbers::pi;
    return {std::cos(latitude) * std::cos(longitude),
            std::sin(latitude),
            std::cos(latitude) * std::sin(longitude)};
}

TEST(MappingHazards, theSeamOfTheSphereDoesNotShowInAFootprint)
{
    expectKept("sphere-seam");
    // Along the equator a step of longitude is the same step of u everywhere.
    constexpr double kStep = 1e-3;
    for (double u = -0.01; u < 0.01; u += 2e-4) {
        const glm::dvec3 d = directionOf(u, 0.5);
        const glm::dvec3 east(-d.z, 0, d.x);
        const Footprint f = sphereFootprint(d, 2 * std::numbers::pi * kStep * east, {0, 0, 0});
        ASSERT_NEAR(f.w1.x, kStep, 1e-2 * kStep) << u;
    }
}

TEST(MappingHazards, everyQuadrantOfTheSphereComesBackAsItIs)
{
    expectKept("sphere-quadrants");
    Random random(11);
    for (int k = 0; k < 20000; ++k) {
        const glm::dvec2 uv(random.in(0, 1), random.in(0, 1));
        const glm::dvec2 off = sphereUv(directionOf(uv.x, uv.y)) - uv;
        ASSERT_LE(std::abs(off.x - std::round(off.x)), 1e-6);
        ASSERT_LE(std::abs(off.y), 1e-6);
    }
    for (const glm::dvec3 axis : {glm::dvec3(0, 1, 0), {0, -1, 0}, {0, 0, 1}, {0, 0, -1}}) {
        const glm::dvec2 uv = sphereUv(axis);
        ASSERT_TRUE(uv.x >= 0 && uv.x < 1 && uv.y >= 0 && uv.y <= 1);
    }
}

TEST(MappingHazards, aFootprintAtAPoleCoversAtMostOnePeriod)
{
    expectKept("sphere-pole");
    Random random(12);
    for (int k = 0; k < 20000; ++k) {
        const double axis = k % 7 == 0 ? 0 : std::abs(random.ofAnySize(-320, 0));
        const double turn = random.in(0, 7);
        const Footprint f = sphereFootprint({axis * std::cos(turn), 1, axis * std::sin(turn)},
                                            {random.in(-1e-2, 1e-2), random.in(-1e-2, 1e-2), 0},
                                            {random.in(-1e-2, 1e-2), 0, random.in(-1e-2, 1e-2)});
        ASSERT_LE(std::hypot(f.w1.x, f.w2.x), 1 + 1e-12);
        ASSERT_LE(std::hypot(f.w1.y, f.w2.y), 1 + 1e-12);
    }
}

void expectReprojection(const Quad& quad, glm::dvec2 point, double size)
{
    const auto uv = inverseBilinear(quad, point);
    ASSERT_TRUE(uv);
    const double off = glm::length(bilinear(quad, *uv) - point);
    ASSERT_LE(off, 5e-7 * size);
}

TEST(MappingHazards, quadsNearAParallelogramAreInverted)
{
    expectKept("parallelogram");
    Random random(13);
    for (int k = 0; k < 20000; ++k) {
        const double size = std::abs(random.ofAnySize(-20, 20));
        const glm::dvec2 b = size * glm::dvec2(random.in(0.6, 1), random.in(-0.3, 0.3));
        const glm::dvec2 c = size * glm::dvec2(random.in(-0.3, 0.3), random.in(0.6, 1));
        const glm::dvec2 off(random.ofAnySize(-18, -1), random.ofAnySize(-18, -1));
        const Quad quad{{0, 0}, b, b + c + size * off, c};
        expectReprojection(quad, bilinear(quad, {random.in(0, 1), random.in(0, 1)}), size);
    }
}

TEST(MappingHazards, quadsWithoutAreaAreRejectedAndFlatOnesInverted)
{
    expectKept("flat-quad");
    Random random(14);
    for (int k = 0; k < 5000; ++k) {
        const double height = std::pow(10, random.in(-10, 0));
        const Quad quad{{0, 0}, {0.9, 0.1 * height}, {1, 1.1 * height}, {0.1, 0.9 * height}};
        expectReprojection(quad, bilinear(quad, {random.in(0, 1), random.in(0, 1)}), 1);
    }
    EXPECT_FALSE(inverseBilinear({{0, 0}, {1, 1}, {3, 3}, {2, 2}}, {1, 1}));
}

TEST(MappingHazards, aBowTieAnswersByItsFixedRule)
{
    expectKept("bow-tie");
    const Quad tie{{0, 0}, {1, 1}, {1, 0}, {0, 1}};
    Random random(15);
    for (int k = 0; k < 5000; ++k) {
        const glm::dvec2 p = bilinear(tie, {random.in(0, 1), random.in(0, 1)});
        expectReprojection(tie, p, 1);
        const auto uv = inverseBilinear(tie, p);
        ASSERT_TRUE(uv->x >= -1e-9 && uv->x <= 1 + 1e-9 && uv->y >= -1e-9 && uv->y <= 1 + 1e-9);
    }
}

} // namespace
} // namespace trixel::test
