// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/resample/fill_holes.h"
#include "tests/core/cancel_after.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace trixel {
namespace {

TEST(FillHolesTest, whatIsKnownStaysAndTheRestLiesWithin)
{
    NoProgress progress;
    constexpr int kWidth = 37;
    constexpr int kHeight = 23;
    std::vector<float> values(kWidth * kHeight * 2, -100.0F);
    std::vector<std::uint8_t> known(kWidth * kHeight);
    for (std::size_t k = 0; k < known.size(); k += 13) {
        known[k] = 1;
        values[2 * k] = static_cast<float>(k % 7) / 7;
        values[2 * k + 1] = 0.25F;
    }
    const std::vector<float> before = values;
    ASSERT_TRUE(fillHoles(values, known, kWidth, kHeight, 2, Threads{2}, progress));
    for (std::size_t k = 0; k < known.size(); ++k) {
        if (known[k] != 0) {
            EXPECT_EQ(values[2 * k], before[2 * k]);
        }
        EXPECT_GE(values[2 * k], 0);
        EXPECT_LE(values[2 * k], 1);
        EXPECT_FLOAT_EQ(values[2 * k + 1], 0.25F); // a constant stays one
    }
}

TEST(FillHolesTest, onePixelFillsAnImageAndNoneLeavesItAlone)
{
    NoProgress progress;
    std::vector<float> values(64 * 3, 0.0F);
    std::vector<std::uint8_t> known(64);
    ASSERT_TRUE(fillHoles(values, known, 8, 8, 3, Threads{1}, progress));
    EXPECT_EQ(std::count(values.begin(), values.end(), 0.0F), 192);
    known[37] = 1;
    values[3 * 37] = 0.5F;
    ASSERT_TRUE(fillHoles(values, known, 8, 8, 3, Threads{1}, progress));
    for (std::size_t k = 0; k < 64; ++k) {
        EXPECT_FLOAT_EQ(values[3 * k], 0.5F);
    }
}

TEST(FillHolesTest, threadsDoNotChangeTheResult)
{
    NoProgress progress;
    std::vector<float> values(101 * 77);
    std::vector<std::uint8_t> known(values.size());
    for (std::size_t k = 0; k < known.size(); k += 29) {
        known[k] = 1;
        values[k] = static_cast<float>(k % 11);
    }
    std::vector<float> again = values;
    ASSERT_TRUE(fillHoles(values, known, 101, 77, 1, Threads{1}, progress));
    ASSERT_TRUE(fillHoles(again, known, 101, 77, 1, Threads{4}, progress));
    EXPECT_EQ(values, again);
}

TEST(FillHolesTest, isLeftWhenCancelledAtWhateverLevel)
{
    std::vector<float> values(100 * 100);
    std::vector<std::uint8_t> known(values.size());
    known[555] = 1;
    int reports = 0;
    for (bool isDone = false; !isDone; ++reports) {
        CancelAfter progress(reports);
        const Status filled = fillHoles(values, known, 100, 100, 1, Threads{2}, progress);
        isDone = filled.has_value();
        EXPECT_TRUE(isDone || filled.error().kind == ErrorKind::Cancelled);
    }
    EXPECT_GT(reports, 20); // of every band of rows
}

} // namespace
} // namespace trixel
