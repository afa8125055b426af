// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/atlas/atlas_tile.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

using namespace trixel;

namespace {

constexpr std::array kBorders{AtlasBorder::None, AtlasBorder::Bilinear};
constexpr std::array kHalves{TexelHalf::Lower, TexelHalf::Upper};

TEST(AtlasTile, everyPixelStoresOneCell)
{
    for (int n = 0; n <= 6; ++n) {
        for (const AtlasBorder border : kBorders) {
            const AtlasTile tile(Level(n), border);
            for (std::uint32_t y = 0; y < tile.side(); ++y) {
                for (std::uint32_t x = 0; x < tile.side(); ++x) {
                    EXPECT_EQ(tile.pixel(tile.cell({x, y})), (AtlasPixel{x, y}));
                }
            }
        }
    }
}

TEST(AtlasTile, withoutBorderItIsThePackedSquare)
{
    for (int n = 0; n <= 6; ++n) {
        const Level level(n);
        const AtlasTile tile(level, AtlasBorder::None);
        EXPECT_EQ(tile.side(), level.resolution());
        for (std::uint32_t k = 0; k < level.texelCount(); ++k) {
            const PackedPixel packed = packedPixel(level, TexelIndex(k));
            const TexelCoord texel = texelAt(level, packed);
            EXPECT_EQ(tile.pixel({texel.i, texel.j, texel.half}), (AtlasPixel{packed.x, packed.y}));
        }
    }
}

TEST(AtlasTile, centroidsAreAtPixelCentres)
{
    for (int n = 0; n <= 6; ++n) {
        const Level level(n);
        for (const AtlasBorder border : kBorders) {
            const AtlasTile tile(level, border);
            for (std::uint32_t k = 0; k < level.texelCount(); ++k) {
                const TexelCoord texel = texelAt(level, TexelIndex(k));
                const AtlasPixel pixel = tile.pixel({texel.i, texel.j, texel.half});
                const glm::dvec2 at = tile.position(centroid(level, texel), texel.half);
                EXPECT_NEAR(at.x, pixel.x + 0.5, 1e-9);
                EXPECT_NEAR(at.y, pixel.y + 0.5, 1e-9);
            }
        }
    }
}

/// Interpolating in one half must not read what belongs to the other, nor leave the tile.
TEST(AtlasTile, stencilsWithinTheFaceStayInTheirHalf)
{
    std::mt19937 random(5);
    std::uniform_real_distribution<double> in(0, 1);
    for (int n = 0; n <= 7; ++n) {
        const AtlasTile tile(Level(n), AtlasBorder::Bilinear);
        for (int k = 0; k < 3000; ++k) {
            glm::dvec2 uv(in(random), in(random));
            if (uv.x + uv.y > 1) {
                uv = 1.0 - uv;
            }
            // Edges and corners too, where stencils reach farthest.
            uv = k % 5 == 1   ? glm::dvec2(uv.x, 0)
                 : k % 5 == 2 ? glm::dvec2(0, uv.y)
                 : k % 5 == 3 ? glm::dvec2(uv.x, 1 - uv.x)
                 : k % 5 == 4 ? glm::dvec2(k % 3 == 1, k % 3 == 2)
                              : uv;
            for (const TexelHalf half : kHalves) {
                const glm::dvec2 at = tile.position(uv, half) - 0.5;
                for (int tap = 0; tap < 4; ++tap) {
                    const double x = std::floor(at.x) + tap % 2;
                    const double y = std::floor(at.y) + tap / 2;
                    ASSERT_TRUE(x >= 0 && y >= 0 && x < tile.side() && y < tile.side());
                    const AtlasPixel pixel{static_cast<std::uint32_t>(x),
                                           static_cast<std::uint32_t>(y)};
                    EXPECT_EQ(tile.cell(pixel).half, half);
                }
            }
        }
    }
}

} // namespace
