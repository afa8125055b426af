// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mapping/sphere.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <numbers>
#include <random>

using namespace trixel;

namespace {

glm::dvec3 directionOf(glm::dvec2 uv)
{
    const double longitude = (uv.x - 0.25) * 2 * std::numbers::pi;
    const double latitude = (uv.y - 0.5) * std::numbers::pi;
    return {std::cos(latitude) * std::cos(longitude),
            std::sin(latitude),
            std::cos(latitude) * std::sin(longitude)};
}

} // namespace

TEST(SphereMap, isTheInverseOfLongitudeAndLatitudeForEveryLength)
{
    std::mt19937 engine(2);
    std::uniform_real_distribution<double> in(0, 1);
    for (int k = 0; k < 5000; ++k) {
        const glm::dvec2 uv(in(engine), in(engine));
        const double length = std::pow(10, 200 * in(engine)-100);
        const glm::dvec2 back = sphereUv(length * directionOf(uv));
        EXPECT_NEAR(back.x, uv.x, 1e-12);
        EXPECT_NEAR(back.y, uv.y, 1e-12);
    }
}

TEST(SphereMap, seamAndPolesAreWhereTheDefinitionPutsThem)
{
    EXPECT_EQ(sphereUv({0, 0, -1}).x, 0);
    EXPECT_NEAR(sphereUv({1, 0, 0}).x, 0.25, 1e-15);
    EXPECT_NEAR(sphereUv({0, 0, 1}).x, 0.5, 1e-15);
    EXPECT_NEAR(sphereUv({-1, 0, 0}).x, 0.75, 1e-15);
    EXPECT_NEAR(sphereUv({-1e-9, 0, -1}).x, 1, 1e-9);
    EXPECT_LT(sphereUv({-1e-30, 0, -1}).x, 1);
    EXPECT_EQ(sphereUv({0, 1, 0}).y, 1);
    EXPECT_EQ(sphereUv({0, -1, 0}).y, 0);
}

TEST(SphereMap, everyInputHasAnAnswerInRange)
{
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    constexpr double inf = std::numeric_limits<double>::infinity();
    for (const double x : {0.0, -0.0, 5e-324, -1.0, 1e308, inf, nan}) {
        for (const double y : {0.0, -0.0, 5e-324, 1.0, -1e308, -inf}) {
            for (const double z : {0.0, -0.0, -5e-324, 1.0, 1e308, nan}) {
                const glm::dvec2 uv = sphereUv({x, y, z});
                EXPECT_TRUE(uv.x >= 0 && uv.x < 1 && uv.y >= 0 && uv.y <= 1);
                const Footprint f = sphereFootprint({x, y, z}, {y, z, x}, {z, x, y});
                EXPECT_LE(std::hypot(f.w1.x, f.w2.x), 1 + 1e-12);
                EXPECT_LE(std::hypot(f.w1.y, f.w2.y), 1 + 1e-12);
            }
        }
    }
}

TEST(SphereFootprint, equalsTheDifferenceQuotientAwayFromSeamAndPoles)
{
    std::mt19937 engine(4);
    std::uniform_real_distribution<double> in(-1, 1);
    for (int k = 0; k < 1000; ++k) {
        const glm::dvec3 d(0.3 + std::abs(in(engine)), in(engine), in(engine));
        const glm::dvec3 a = 1e-3 * glm::dvec3(in(engine), in(engine), in(engine));
        const glm::dvec3 b = 1e-3 * glm::dvec3(in(engine), in(engine), in(engine));
        const Footprint f = sphereFootprint(d, a, b);
        const glm::dvec2 da = sphereUv(d + a / 2.0) - sphereUv(d - a / 2.0);
        const glm::dvec2 db = sphereUv(d + b / 2.0) - sphereUv(d - b / 2.0);
        EXPECT_NEAR(glm::length(f.w1 - da), 0, 1e-7);
        EXPECT_NEAR(glm::length(f.w2 - db), 0, 1e-7);
    }
}

TEST(SphereFootprint, coversOnePeriodAtAPoleAndKeepsItsHeight)
{
    const Footprint f = sphereFootprint({0, 1, 0}, {1e-3, 0, 0}, {0, 0, 1e-3});
    EXPECT_NEAR(std::hypot(f.w1.x, f.w2.x), 1, 1e-12);
    EXPECT_NEAR(std::abs(f.w1.y), 1e-3 / std::numbers::pi, 1e-9);
}
