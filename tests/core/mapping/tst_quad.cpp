// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mapping/quad.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <random>

using namespace trixel;

namespace {

struct Random
{
    std::mt19937 engine{5};
    double in(double low, double high)
    {
        return std::uniform_real_distribution<double>(low, high)(engine);
    }
    glm::dvec2 vec(double size) { return {in(-size, size), in(-size, size)}; }
    /// The unit square with its corners moved a little: convex.
    Quad convex(double amount)
    {
        return {vec(amount),
                glm::dvec2(1, 0) + vec(amount),
                glm::dvec2(1, 1) + vec(amount),
                glm::dvec2(0, 1) + vec(amount)};
    }
};

} // namespace

TEST(InverseQuad, findsTheOnlyPointInsideAConvexQuad)
{
    Random random;
    for (int k = 0; k < 5000; ++k) {
        const Quad quad = random.convex(0.24);
        const glm::dvec2 uv(random.in(0, 1), random.in(0, 1));
        const auto back = inverseBilinear(quad, bilinear(quad, uv));
        ASSERT_TRUE(back);
        EXPECT_NEAR(glm::length(*back - uv), 0, 1e-12);
    }
}

TEST(InverseQuad, cornersAndEdgesComeBackExactlyEnough)
{
    const Quad quad{{3, 1}, {9, 2}, {7, 8}, {2, 5}};
    for (const glm::dvec2 uv : {glm::dvec2(0, 0), {1, 0}, {1, 1}, {0, 1}, {0.5, 0}, {1, 0.25}}) {
        const auto back = inverseBilinear(quad, bilinear(quad, uv));
        ASSERT_TRUE(back);
        EXPECT_NEAR(glm::length(*back - uv), 0, 1e-14);
    }
}

TEST(InverseQuad, goesOnOutsideTheQuad)
{
    const Quad square;
    const auto outside = inverseBilinear(square, {2.5, -1});
    ASSERT_TRUE(outside);
    EXPECT_NEAR(glm::length(*outside - glm::dvec2(2.5, -1)), 0, 1e-14);
}

TEST(InverseQuad, quadsWithoutAreaAndWildNumbersGiveNothing)
{
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    constexpr double inf = std::numeric_limits<double>::infinity();
    EXPECT_FALSE(inverseBilinear({{1, 1}, {1, 1}, {1, 1}, {1, 1}}, {1, 1}));
    EXPECT_FALSE(inverseBilinear({{0, 0}, {1, 1}, {3, 3}, {2, 2}}, {1, 1}));
    EXPECT_FALSE(inverseBilinear({{0, 0}, {1, 0}, {1, 1e-14}, {0, 1e-14}}, {0.5, 0}));
    EXPECT_FALSE(inverseBilinear({}, {nan, 0}));
    EXPECT_FALSE(inverseBilinear({}, {0, inf}));
    EXPECT_FALSE(inverseBilinear({{0, nan}, {1, 0}, {1, 1}, {0, 1}}, {0, 0}));
    EXPECT_TRUE(inverseBilinear({{0, 0}, {1e-200, 0}, {1e-200, 1e-200}, {0, 1e-200}}, {0, 0}));
}

TEST(InverseQuad, aBowTieAnswersByTheFixedRule)
{
    // P10 and P11 exchanged: the map folds; each point of it is inside once or twice.
    const Quad tie{{0, 0}, {1, 1}, {1, 0}, {0, 1}};
    Random random;
    for (int k = 0; k < 2000; ++k) {
        const glm::dvec2 uv(random.in(0, 1), random.in(0, 1));
        const glm::dvec2 p = bilinear(tie, uv);
        const auto back = inverseBilinear(tie, p);
        ASSERT_TRUE(back);
        EXPECT_NEAR(glm::length(bilinear(tie, *back) - p), 0, 5e-7);
        EXPECT_GE(back->x, -1e-9);
        EXPECT_LE(back->x, 1 + 1e-9);
        EXPECT_EQ(back->x, inverseBilinear(tie, p)->x);
    }
}
