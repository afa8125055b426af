// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/paint_squares.h"

#include <gtest/gtest.h>

#include <random>
#include <vector>

using namespace trixel;
using namespace trixel::render;

TEST(PaintSquares, neverOverlapAndStayWithinTheSheet)
{
    constexpr std::uint32_t kHeight = 2048;
    PaintSquares squares(kHeight);
    std::vector<int> owner(std::size_t{PaintSquares::kWidth} * kHeight, -1);
    std::mt19937 random(1);
    std::size_t texels = 0;
    for (int k = 0; k < 4000; ++k) {
        const Level level(static_cast<int>(random() % 10));
        const auto square = squares.add(level);
        if (!square) {
            continue;
        }
        ASSERT_EQ(square->level, level);
        const std::uint32_t side = level.resolution();
        ASSERT_LE(square->x + side, PaintSquares::kWidth);
        ASSERT_LE(square->y + side, squares.rowsUsed());
        ASSERT_LE(squares.rowsUsed(), kHeight);
        for (std::uint32_t y = 0; y < side; ++y) {
            for (std::uint32_t x = 0; x < side; ++x) {
                int& here = owner[(square->y + y) * PaintSquares::kWidth + square->x + x];
                ASSERT_EQ(here, -1);
                here = k;
                ++texels;
            }
        }
    }
    EXPECT_GT(texels, 0.7 * PaintSquares::kWidth * kHeight);
}

TEST(PaintSquares, aFullSheetRefusesAndServesAgainOnceCleared)
{
    PaintSquares squares(512);
    for (int k = 0; k < 8; ++k) {
        EXPECT_TRUE(squares.add(Level(9)));
    }
    EXPECT_FALSE(squares.add(Level(9)));
    EXPECT_FALSE(squares.add(Level(0)));
    squares.clear();
    EXPECT_EQ(squares.rowsUsed(), 0U);
    EXPECT_TRUE(squares.add(Level(0)));
    EXPECT_FALSE(squares.add(Level(10)));
}

TEST(PaintSquares, aWordSaysAllOfASquare)
{
    for (const PaintSquare& square : {PaintSquare{0, 0, Level(0)},
                                      PaintSquare{4095, 8191, Level(12)},
                                      PaintSquare{123, 4567, Level(7)}}) {
        EXPECT_NE(square.word(), 0U);
        EXPECT_EQ(PaintSquare::of(square.word()), square);
    }
}
