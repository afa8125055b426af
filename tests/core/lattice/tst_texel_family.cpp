// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/lattice/reduction.h"
#include "core/lattice/texel_family.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <vector>

using namespace trixel;

namespace {

std::vector<TexelCoord> texelsOf(Level level)
{
    std::vector<TexelCoord> texels;
    for (std::uint32_t k = 0; k < level.texelCount(); ++k) {
        texels.push_back(texelAt(level, static_cast<TexelIndex>(k)));
    }
    return texels;
}

glm::dvec2 middle(Level level, TexelCoord texel)
{
    return centroid(level, texel);
}

double cross(glm::dvec2 a, glm::dvec2 b)
{
    return a.x * b.y - a.y * b.x;
}

/// By the corners alone: what "covers" means.
bool covers(Level level, TexelCoord texel, glm::dvec2 point)
{
    const auto c = corners(level, texel);
    const double a = cross(c[1] - c[0], point - c[0]);
    const double b = cross(c[2] - c[1], point - c[1]);
    const double d = cross(c[0] - c[2], point - c[2]);
    return (a > 0 && b > 0 && d > 0) || (a < 0 && b < 0 && d < 0);
}

std::set<std::uint32_t> indices(Level level, const std::vector<PackedRow>& rows)
{
    std::set<std::uint32_t> all;
    for (const PackedRow& row : rows) {
        for (std::uint16_t k = 0; k < row.count; ++k) {
            const PackedPixel pixel{static_cast<std::uint16_t>(row.first.x + k), row.first.y};
            const auto index =
                static_cast<std::uint32_t>(indexOf(texelIndex(level, texelAt(level, pixel))));
            EXPECT_TRUE(all.insert(index).second) << "twice";
        }
    }
    return all;
}

} // namespace

TEST(TexelFamily, theParentOfEachChildIsTheTexel)
{
    for (int n = 0; n <= 5; ++n) {
        const Level level(n);
        for (const TexelCoord texel : texelsOf(level)) {
            for (const TexelCoord child : childrenOf(level, texel)) {
                ASSERT_TRUE(isValid(Level(n + 1), child));
                EXPECT_EQ(parentOf(Level(n + 1), child), texel);
            }
        }
    }
}

TEST(TexelFamily, childrenTileTheAreaOfTheirParent)
{
    for (int n = 0; n <= 5; ++n) {
        const Level level(n);
        const Level fine(n + 1);
        std::set<std::size_t> all;
        for (const TexelCoord texel : texelsOf(level)) {
            const auto children = childrenOf(level, texel);
            for (const TexelCoord child : children) {
                EXPECT_TRUE(covers(level, texel, middle(fine, child)));
                all.insert(indexOf(texelIndex(fine, child)));
            }
            EXPECT_EQ(children[0].half, texel.half);
            EXPECT_EQ(children[1].half, texel.half);
            EXPECT_EQ(children[2].half, texel.half);
            EXPECT_NE(children[3].half, texel.half);
            // The one between the others has the same middle as all of them.
            const glm::dvec2 apart = middle(fine, children[3]) - middle(level, texel);
            EXPECT_LT(std::abs(apart.x) + std::abs(apart.y), 1e-12);
        }
        EXPECT_EQ(all.size(), fine.texelCount());
    }
}

TEST(TexelFamily, anAncestorCoversTheTexelAtEveryLevel)
{
    const Level fine(5);
    for (const TexelCoord texel : texelsOf(fine)) {
        TexelCoord step = texel;
        for (int n = 5; n >= 0; --n) {
            const TexelCoord ancestor = ancestorOf(fine, texel, Level(n));
            ASSERT_TRUE(isValid(Level(n), ancestor));
            EXPECT_TRUE(covers(Level(n), ancestor, middle(fine, texel)));
            EXPECT_EQ(ancestor, step) << "one level at a time";
            step = n > 0 ? parentOf(Level(n), step) : step;
        }
    }
    EXPECT_EQ(ancestorOf(Level(12), {4095, 0, TexelHalf::Lower}, Level(0)), TexelCoord());
}

TEST(TexelFamily, descendantsAreExactlyTheTexelsWithThatAncestor)
{
    for (int n = 0; n <= 3; ++n) {
        for (int finer = n; finer <= 6; ++finer) {
            const Level level(n);
            const Level fine(finer);
            for (const TexelCoord texel : texelsOf(level)) {
                const auto rows = packedDescendants(level, texel, fine);
                EXPECT_EQ(rows.size(), (std::size_t{2} << (finer - n)) - 1);
                std::set<std::uint32_t> expected;
                for (const TexelCoord t : texelsOf(fine)) {
                    if (ancestorOf(fine, t, level) == texel) {
                        expected.insert(static_cast<std::uint32_t>(indexOf(texelIndex(fine, t))));
                    }
                }
                EXPECT_EQ(indices(fine, rows), expected) << n << " " << finer;
            }
        }
    }
}

TEST(TexelFamily, theBoxTakesATexelFromBesideExceptOnTheDiagonal)
{
    for (int n = 0; n <= 5; ++n) {
        const Level level(n);
        const Level fine(n + 1);
        const int last = static_cast<int>(level.resolution()) - 1;
        for (const TexelCoord texel : texelsOf(level)) {
            const PackedPixel pixel = packedPixel(level, texel);
            int beside = 0;
            for (const PackedPixel from : boxPixels(pixel)) {
                beside += parentOf(fine, texelAt(fine, from)) == texel ? 0 : 1;
            }
            EXPECT_EQ(beside, pixel.x + pixel.y == last ? 0 : 1);
        }
    }
}

TEST(TexelFamilyDeathTest, texelsOfOtherLevelsAreRefused)
{
    EXPECT_DEATH(ancestorOf(Level(1), {2, 0, TexelHalf::Lower}, Level(0)), "a texel of the level");
    EXPECT_DEATH(ancestorOf(Level(1), {}, Level(2)), "not finer");
    EXPECT_DEATH(parentOf(Level(0), {}), "go up");
    EXPECT_DEATH(childrenOf(Level(Level::kMax), {}), "go down");
    EXPECT_DEATH(packedDescendants(Level(2), {}, Level(1)), "not coarser");
}
