// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/paint/dab_raster.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <random>
#include <vector>

using namespace trixel;

namespace {

using Corners = std::array<glm::vec3, 3>;

/// Distance in radii per texel of the packed square, by the spans of both halves; -1 where none
/// comes, -2 where two do.
std::vector<float> rasterised(const Corners& corners, Level level, const Dab& dab)
{
    std::vector<float> distances(level.texelCount(), -1);
    for (const TexelHalf half : {TexelHalf::Lower, TexelHalf::Upper}) {
        const HalfRaster raster(corners, level, half, dab);
        const RowRange rows = raster.rows();
        for (std::uint32_t row = rows.begin; row < rows.end; ++row) {
            const DabSpan span = raster.span(row);
            for (std::uint32_t x = span.begin; x < span.end; ++x) {
                const float along = span.start + static_cast<float>(x - span.begin) * span.step;
                float& distance = distances.at(row * level.resolution() + x);
                distance = distance == -1 ? std::sqrt(span.heightSquared + along * along) : -2.0F;
            }
        }
    }
    return distances;
}

double distanceTo(const Corners& corners, Level level, std::uint32_t texel, const Dab& dab)
{
    const glm::dvec2 uv = centroid(level, texelAt(level, TexelIndex{texel}));
    const glm::dvec3 a(corners[0]);
    const glm::dvec3 at =
        a + uv.x * (glm::dvec3(corners[1]) - a) + uv.y * (glm::dvec3(corners[2]) - a);
    return glm::length(at - glm::dvec3(dab.centre)) / dab.radius;
}

void expectExactSpans(const Corners& corners, Level level, const Dab& dab)
{
    const std::vector<float> found = rasterised(corners, level, dab);
    for (std::uint32_t texel = 0; texel < level.texelCount(); ++texel) {
        const double distance = distanceTo(corners, level, texel, dab);
        if (found[texel] != -1) {
            ASSERT_NEAR(found[texel], distance, 1e-5) << "level " << level.log2() << " " << texel;
        }
        if (std::abs(distance - 1) > 1e-6) {
            ASSERT_EQ(found[texel] != -1, distance < 1)
                << "level " << level.log2() << " " << texel << " at " << distance;
        }
    }
}

} // namespace

TEST(DabRaster, everyTexelOfBothHalvesComesOnceUnderADabLargerThanTheFace)
{
    const Corners corners{glm::vec3{1, 2, 3}, {4, 1, 2}, {2, 5, 1}};
    for (int n = 0; n <= 7; ++n) {
        const Dab dab{{2, 2, 2}, {0, 0, 1}, 100.0F, 1};
        for (const float distance : rasterised(corners, Level(n), dab)) {
            ASSERT_GE(distance, 0.0F) << "level " << n;
        }
        expectExactSpans(corners, Level(n), dab);
    }
}

TEST(DabRaster, spansHoldTheCentroidsWithinTheRadiusAndNoOthers)
{
    std::mt19937 random(1);
    std::uniform_real_distribution<float> place(-1, 1);
    const auto point = [&] {
        const float x = place(random);
        const float y = place(random);
        return glm::vec3(x, y, place(random));
    };
    for (int k = 0; k < 1500; ++k) {
        const Corners corners{point(), point(), point()};
        const glm::vec3 centre =
            k % 3 == 0 ? point() : corners[0] * 0.4F + corners[1] * 0.35F + corners[2] * 0.25F;
        const Dab dab{centre, {0, 0, 1}, std::exp2(place(random) * 4 - 2), 1};
        expectExactSpans(corners, Level(k % 7), dab);
    }
}

TEST(DabRaster, facesWithoutAreaAreCoveredTooNeedlesAndPointsAlike)
{
    const glm::vec3 a(0.3F, -0.2F, 0.7F);
    const glm::vec3 b(-0.5F, 0.1F, 0.2F);
    const std::vector<Corners> faces{{a, a, b},
                                     {a, b, a},
                                     {b, a, a},
                                     {a, a, a},
                                     {a, 0.5F * (a + b), b},
                                     {a, b, b + glm::vec3(1e-7F, 0, 0)}};
    for (const Corners& corners : faces) {
        for (int n = 0; n <= 6; ++n) {
            for (const float radius : {0.05F, 0.3F, 5.0F}) {
                expectExactSpans(corners, Level(n), {a, {}, radius, 1});
                expectExactSpans(corners, Level(n), {0.5F * (a + b), {}, radius, 1});
            }
        }
    }
}

TEST(DabRaster, farFromTheOriginAndAtTheHighestLevelTheCentroidsStillMeet)
{
    const glm::vec3 away(1000, -2000, 500);
    const Corners corners{away, away + glm::vec3(3, 0, 0), away + glm::vec3(0, 3, 1)};
    const Level level(Level::kMax);
    const Dab dab{away + glm::vec3(1, 1, 1.0F / 3), {0, 0, 1}, 0.01F, 1};
    std::size_t inside = 0;
    for (const TexelHalf half : {TexelHalf::Lower, TexelHalf::Upper}) {
        const HalfRaster raster(corners, level, half, dab);
        const RowRange rows = raster.rows();
        for (std::uint32_t row = rows.begin; row < rows.end; ++row) {
            const DabSpan span = raster.span(row);
            for (std::uint32_t x = span.begin; x < span.end; ++x) {
                const float along = span.start + static_cast<float>(x - span.begin) * span.step;
                const std::uint32_t texel = row * level.resolution() + x;
                ASSERT_NEAR(std::sqrt(span.heightSquared + along * along),
                            distanceTo(corners, level, texel, dab),
                            1e-5);
                ++inside;
            }
        }
    }
    // Area of the disc over the area of a texel: |(3,0,0) x (0,3,1)| / 2 / 4^12.
    const double disc = 3.14159265 * 1e-4;
    const double texelArea = std::sqrt(90.0) / 2 / 16777216;
    EXPECT_NEAR(static_cast<double>(inside) * texelArea / disc, 1, 0.02);
}

TEST(DabRaster, aSmallDabLooksAtFewRowsOfALargeFace)
{
    const Corners corners{glm::vec3{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    const Dab dab{{0.3F, 0.3F, 0}, {0, 0, 1}, 0.001F, 1};
    for (const TexelHalf half : {TexelHalf::Lower, TexelHalf::Upper}) {
        const RowRange rows = HalfRaster(corners, Level(12), half, dab).rows();
        EXPECT_LE(rows.end - rows.begin, 12U); // the dab is 8.2 texels across
        const Dab above{{0.3F, 0.3F, 0.0011F}, {0, 0, 1}, 0.001F, 1};
        EXPECT_TRUE(HalfRaster(corners, Level(12), half, above).rows().isEmpty());
    }
}
