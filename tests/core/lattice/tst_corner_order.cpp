// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/lattice/corner_order.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <set>

using namespace trixel;

namespace {

/// Weights of V0, V1, V2 at a point.
std::array<double, 3> weights(glm::dvec2 uv)
{
    return {1 - uv.x - uv.y, uv.x, uv.y};
}

} // namespace

TEST(CornerOrder, thereAreSixAndTheirWaysBack)
{
    std::set<CornerOrder> seen(kCornerOrders.begin(), kCornerOrders.end());
    EXPECT_EQ(seen.size(), 6U);
    int over = 0;
    for (const CornerOrder& order : kCornerOrders) {
        EXPECT_TRUE(seen.contains(inverse(order)));
        EXPECT_EQ(inverse(inverse(order)), order);
        EXPECT_EQ(turnsOver(inverse(order)), turnsOver(order));
        over += turnsOver(order) ? 1 : 0;
    }
    EXPECT_EQ(over, 3);
}

TEST(CornerOrder, aTexelKeepsItsPlaceOnTheTriangle)
{
    for (const CornerOrder& order : kCornerOrders) {
        for (int log2 = 0; log2 <= 5; ++log2) {
            const Level level(log2);
            std::set<std::uint32_t> met;
            for (std::uint32_t k = 0; k < level.texelCount(); ++k) {
                const TexelCoord here = texelAt(level, TexelIndex(k));
                const TexelCoord there = texelInOrder(level, here, order);
                ASSERT_TRUE(isValid(level, there));
                met.insert(static_cast<std::uint32_t>(texelIndex(level, there)));
                const auto a = weights(centroid(level, here));
                const auto b = weights(centroid(level, there));
                for (std::size_t c = 0; c < 3; ++c) {
                    ASSERT_NEAR(a[c], b[order[c]], 1e-12);
                }
                ASSERT_EQ(texelInOrder(level, there, inverse(order)), here);
            }
            EXPECT_EQ(met.size(), level.texelCount()) << "every texel once";
        }
    }
}
