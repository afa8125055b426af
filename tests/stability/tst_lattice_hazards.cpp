// SPDX-License-Identifier: GPL-3.0-or-later
//
// Texels under points, weights along rows, textures as data: one test a row of the table.
#include "core/lattice/texel.h"
#include "core/study/stability/sweeps.h"
#include "tests/stability/hazard_row.h"

#include <array>
#include <bit>
#include <glm/geometric.hpp>
#include <vector>

namespace trixel::test {
namespace {

/// Not inlined: the vectoriser of GCC 12 takes a pair of doubles that become floats and doubles
/// again for unchanged.
[[gnu::noinline]] float asStored(double coordinate)
{
    return static_cast<float>(coordinate);
}

/// In texels, by the three lines that bound the texel.
long double distanceFrom(Level level, TexelCoord texel, long double u, long double v)
{
    const long double x = u * level.resolution() - texel.i;
    const long double y = v * level.resolution() - texel.j;
    const long double beyond = (x + y - 1) / std::sqrt(2.0L);
    return texel.half == TexelHalf::Lower ? std::max({-x, -y, beyond, 0.0L})
                                          : std::max({x - 1, y - 1, -beyond, 0.0L});
}

TEST(LatticeHazards, theTexelOfAStoredPointIsAtThePoint)
{
    expectKept("texel-precision");
    Random random(21);
    for (int k = 0; k < 100000; ++k) {
        const Level level(k % (Level::kMax + 1));
        const double r = level.resolution();
        // On a line of the lattice, give or take an ulp of the float.
        const double u = std::floor(random.in(0, 1) * r) / r + random.in(-1, 1) * 0x1p-24;
        const double v = random.in(0, 1) * (1 - u);
        if (u < 0 || v < 0) {
            continue;
        }
        const TexelCoord texel = texelAt(level, glm::dvec2(asStored(u), asStored(v)));
        ASSERT_TRUE(isValid(level, texel));
        ASSERT_LE(distanceFrom(level, texel, u, v), 1.5 * r * 0x1p-24);
    }
}

TEST(LatticeHazards, everyPointOfTheBorderHasATexelOfTheFace)
{
    expectKept("texel-borders");
    Random random(22);
    for (int k = 0; k < 100000; ++k) {
        const Level level(k % (Level::kMax + 1));
        const auto u = static_cast<float>(random.in(0, 1));
        float v = 1 - u; // u + v is 1, or an ulp more or less
        v = k % 3 == 0 ? std::nextafter(v, 2.0F) : k % 3 == 1 ? std::nextafter(v, -1.0F) : v;
        ASSERT_TRUE(isValid(level, texelAt(level, glm::dvec2(u, v))));
    }
    for (int k = 0; k < 100000; ++k) {
        const auto any = [&] {
            return static_cast<double>(
                std::bit_cast<float>(static_cast<std::uint32_t>(random.engine())));
        };
        const Level level(k % (Level::kMax + 1));
        ASSERT_TRUE(isValid(level, texelAt(level, glm::dvec2(any(), any()))));
    }
}

TEST(LatticeHazards, gaussianWeightsAreThoseOfExpAlongAnyRow)
{
    expectKept("gaussian-runs");
    // From 40 standard deviations on one side, where all underflows, to 40 on the other.
    for (int n = 2; n <= Level::kMax; ++n) {
        const Level level(n);
        const glm::dvec2 start(-40, 0.1);
        const glm::dvec2 step(80.0 / level.resolution(), 0);
        double sum = 0;
        for (std::uint32_t k = 0; k < level.resolution(); ++k) {
            const glm::dvec2 p = start + static_cast<double>(k) * step;
            sum += std::exp(-glm::dot(p, p) / 2);
        }
        EXPECT_NEAR(sweeps::exactRowWeight(level, start, step, 0) / sum, 1, 1e-5) << n;
    }
    // Steps of thousands of standard deviations, relative to the nearest point: it alone weighs.
    EXPECT_NEAR(sweeps::exactRowWeight(Level(1), {3000, 4000}, {-3000, 0}, 1.6e7), 1, 1e-5);
}

TEST(LatticeHazards, testTexturesAreDataThatNoBuildChanges)
{
    expectKept("stored-textures");
}

} // namespace
} // namespace trixel::test
