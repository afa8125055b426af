// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/lattice/edge_transfer.h"
#include "core/lattice/paint_projection.h"
#include "core/lattice/reduction.h"
#include "core/lattice/texel.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <set>
#include <vector>

using namespace trixel;

namespace {

std::vector<TexelCoord> texelsOf(Level level)
{
    std::vector<TexelCoord> texels;
    const auto resolution = static_cast<std::uint16_t>(level.resolution());
    for (std::uint16_t j = 0; j < resolution; ++j) {
        for (std::uint16_t i = 0; i + j < resolution; ++i) {
            texels.push_back({i, j, TexelHalf::Lower});
            if (i + j + 1 < resolution) {
                texels.push_back({i, j, TexelHalf::Upper});
            }
        }
    }
    return texels;
}

/// Area of the overlap's complement is tested through centroids: a texel's centroid lies inside.
bool contains(const std::array<glm::dvec2, 3>& c, glm::dvec2 p)
{
    const auto side = [&](int a, int b) {
        const glm::dvec2 e = c[b] - c[a];
        const glm::dvec2 d = p - c[a];
        return e.x * d.y - e.y * d.x;
    };
    return side(0, 1) > 0 && side(1, 2) > 0 && side(2, 0) > 0;
}

} // namespace

TEST(Lattice, everyPackedPixelStoresExactlyOneTexel)
{
    for (int n = 0; n <= 6; ++n) {
        const Level level(n);
        const auto texels = texelsOf(level);
        ASSERT_EQ(texels.size(), level.texelCount());
        std::set<std::uint32_t> seen;
        for (const TexelCoord& texel : texels) {
            const TexelIndex index = texelIndex(level, texel);
            EXPECT_TRUE(seen.insert(static_cast<std::uint32_t>(index)).second);
            EXPECT_EQ(texelAt(level, index), texel);
        }
        EXPECT_EQ(*seen.rbegin(), level.texelCount() - 1);
    }
}

TEST(Lattice, upperLinearIndexCountsFromTheEnd)
{
    const Level level(3);
    for (const TexelCoord& t : texelsOf(level)) {
        const std::uint32_t expected =
            t.half == TexelHalf::Lower ? t.i + t.j * 8U : 63U - (t.j + t.i * 8U);
        EXPECT_EQ(static_cast<std::uint32_t>(texelIndex(level, t)), expected);
    }
}

TEST(Lattice, theCentroidOfATexelLiesInItAndFindsIt)
{
    for (int n : {0, 1, 2, 5, 8}) {
        const Level level(n);
        for (const TexelCoord& texel : texelsOf(level)) {
            EXPECT_EQ(texelAt(level, centroid(level, texel)), texel);
            EXPECT_TRUE(contains(corners(level, texel), centroid(level, texel)));
        }
    }
}

TEST(Lattice, pointsOnAndOutsideTheRimFindAValidTexel)
{
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const double inf = std::numeric_limits<double>::infinity();
    for (int n : {0, 1, 4, 12}) {
        const Level level(n);
        for (double u : {-inf, -1.0, -1e-30, 0.0, 0.3, 1.0, 1.0 + 1e-12, 2.0, inf, nan}) {
            for (double v : {-inf, -1.0, 0.0, 0.7, std::nextafter(0.7, 1.0), 1.0, 2.0, inf, nan}) {
                EXPECT_TRUE(isValid(level, texelAt(level, glm::dvec2(u, v)))) << u << ' ' << v;
            }
        }
    }
    const Level level(4);
    EXPECT_EQ(texelAt(level, glm::dvec2(1, 0)), (TexelCoord{15, 0, TexelHalf::Lower}));
    EXPECT_EQ(texelAt(level, glm::dvec2(0, 1)), (TexelCoord{0, 15, TexelHalf::Lower}));
}

TEST(Lattice, floorsOfBarycentricsSumByHalf)
{
    const Level level(4);
    const auto cells = [&](double x) { return std::floor(x * 16); };
    for (const TexelCoord& t : texelsOf(level)) {
        const glm::dvec2 c = centroid(level, t);
        const double sum = cells(c.x) + cells(c.y) + cells(1 - c.x - c.y);
        EXPECT_EQ(sum, t.half == TexelHalf::Lower ? 15 : 14);
    }
}

TEST(PaintProjection, pixelCentresMeetTexelCentroidsInBothHalves)
{
    for (int n = 0; n <= 6; ++n) {
        const Level level(n);
        for (const TexelCoord& texel : texelsOf(level)) {
            const PackedPixel pixel = packedPixel(level, texel);
            const glm::dvec2 at = toPacked(level, texel.half, centroid(level, texel));
            EXPECT_NEAR(at.x, pixel.x + 0.5, 1e-12);
            EXPECT_NEAR(at.y, pixel.y + 0.5, 1e-12);
            const glm::dvec2 back = fromPacked(level, texel.half, at);
            EXPECT_NEAR(glm::dvec2(back - centroid(level, texel)).x, 0, 1e-12);
        }
    }
}

TEST(PaintProjection, theTwoTrianglesCoverEveryPixelOnceAndZeroOffsetMissesTheDiagonal)
{
    const auto covers = [](Level level, TexelHalf half, PackedPixel p, double offset) {
        const glm::dvec2 uv = fromPacked(level, half, glm::dvec2(p.x + 0.5, p.y + 0.5), offset);
        return uv.x >= 0 && uv.y >= 0 && uv.x + uv.y <= 1;
    };
    for (int n = 0; n <= 6; ++n) {
        const Level level(n);
        std::uint32_t wrong = 0;
        for (std::uint32_t k = 0; k < level.texelCount(); ++k) {
            const PackedPixel p = packedPixel(level, static_cast<TexelIndex>(k));
            const TexelHalf half = texelAt(level, p).half;
            const TexelHalf other = half == TexelHalf::Lower ? TexelHalf::Upper : TexelHalf::Lower;
            EXPECT_TRUE(covers(level, half, p, kPaintOffset));
            EXPECT_FALSE(covers(level, other, p, kPaintOffset));
            wrong += covers(level, other, p, 0.0) ? 1 : 0;
        }
        EXPECT_EQ(wrong, level.resolution()); // the diagonal, with offset 0
    }
}

TEST(Reduction, everyFineTexelHasOneParentThatContainsItsCentroid)
{
    for (int n = 1; n <= 6; ++n) {
        const Level fine(n);
        std::set<std::uint32_t> seen;
        for (const TexelCoord& parent : texelsOf(fine.coarser())) {
            for (const PackedPixel& child :
                 finerPixels(fine, packedPixel(fine.coarser(), parent))) {
                EXPECT_TRUE(
                    seen.insert(static_cast<std::uint32_t>(texelIndex(fine, child))).second);
                EXPECT_EQ(texelAt(fine.coarser(), centroid(fine, texelAt(fine, child))), parent);
            }
        }
        EXPECT_EQ(seen.size(), fine.texelCount());
    }
}

TEST(EdgeTransfer, crossingAndReturningIsTheIdentity)
{
    const glm::dvec2 uv(0.3, 0.2);
    for (LocalEdge from : kLocalEdges) {
        for (LocalEdge to : kLocalEdges) {
            const glm::dvec2 back = acrossEdge(to, from, acrossEdge(from, to, uv));
            EXPECT_NEAR(back.x, uv.x, 1e-15);
            EXPECT_NEAR(back.y, uv.y, 1e-15);
        }
    }
}

TEST(EdgeTransfer, theStartOfAnEdgeIsTheEndOfTheNeighbours)
{
    for (LocalEdge from : kLocalEdges) {
        for (LocalEdge to : kLocalEdges) {
            const glm::dvec2 start = fromEdge(from, {0, 0});
            const glm::dvec2 there = acrossEdge(from, to, start);
            EXPECT_NEAR(toEdge(to, there).t, 1.0, 1e-15);
            EXPECT_NEAR(toEdge(to, there).h, 0.0, 1e-15);
        }
    }
}

TEST(EdgeTransfer, borderTexelsOfAnEdgeMeetInReverseOrder)
{
    const Level level(3);
    for (LocalEdge from : kLocalEdges) {
        for (LocalEdge to : kLocalEdges) {
            for (int k = 0; k < 8; ++k) {
                const auto justInside = [&](LocalEdge e, int i) {
                    return texelAt(level, fromEdge(e, {(i + 1.0 / 3) / 8, (1.0 / 3) / 8}));
                };
                // A step down across the edge from texel k's middle lands in texel R-1-k.
                const glm::dvec2 outside = fromEdge(from, {(k + 0.5) / 8, -0.01 / 8});
                const TexelCoord met = texelAt(level, acrossEdge(from, to, outside));
                EXPECT_EQ(met, justInside(to, 7 - k));
                EXPECT_EQ(met.half, TexelHalf::Lower);
            }
        }
    }
}
