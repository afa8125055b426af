// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/look/look_commands.h"
#include "ui/look/look_words.h"
#include "ui/look/value_axis.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <optional>
#include <vector>

namespace trixel::ui {
namespace {

using render::Look;

std::vector<int> walk(const TexelFormat& format, int by, int steps)
{
    std::vector<int> seen; // -1 luminance, -2 colour
    Look look;
    for (int k = 0; k < steps; ++k) {
        look = nextChannel(format, look, by);
        seen.push_back(look.channel ? *look.channel : look.luminance ? -1 : -2);
    }
    return seen;
}

TEST(LookCommands, channelsAreWalkedRoundBothWays)
{
    const TexelFormat rgba{TexelType::UInt8, 4, std::uint16_t{3}};
    EXPECT_EQ(walk(rgba, 1, 7), (std::vector{0, 1, 2, 3, -1, -2, 0}));
    EXPECT_EQ(walk(rgba, -1, 7), (std::vector{-1, 3, 2, 1, 0, -2, -1}));
    EXPECT_EQ(walk({TexelType::UInt8, 1, {}}, 1, 2), (std::vector{-2, -2}));
    EXPECT_EQ(walk({TexelType::UInt8, 2, {}}, 1, 3), (std::vector{1, -2, 1}));
}

TEST(LookCommands, exposureStaysWithinWhatCanBeSet)
{
    EXPECT_EQ(exposed({}, 0.5F).exposure, 0.5F);
    EXPECT_EQ(exposed({}, 100).exposure, kMostStops);
    EXPECT_EQ(exposed({}, -100).exposure, -kMostStops);
}

TEST(LookCommands, aRangeIsOfStoredValuesWhateverTheExposure)
{
    Look look;
    look.exposure = 3;
    look = ranged(look, 0.25F, 0.75F);
    EXPECT_EQ(look.blackValue(), 0.25F);
    EXPECT_EQ(look.whiteValue(), 0.75F);
    EXPECT_EQ(look.exposure, 3);
}

TEST(LookCommands, aRangeThatCannotBeShownIsRefused)
{
    const Look look;
    const float nan = std::nanf("");
    const float infinite = std::numeric_limits<float>::infinity();
    const float least = std::numeric_limits<float>::denorm_min();
    for (const auto& [black, white] : {std::pair(0.5F, 0.5F),
                                       std::pair(nan, 1.0F),
                                       std::pair(0.0F, infinite),
                                       std::pair(-3e38F, 3e38F),
                                       std::pair(0.0F, least)}) {
        EXPECT_EQ(ranged(look, black, white), look) << black << " " << white;
    }
}

TEST(LookWords, nameWhatIsNotNeutral)
{
    const TexelFormat rgba{TexelType::Half, 4, std::uint16_t{3}};
    EXPECT_EQ(describe(rgba, {}), QString());
    Look look;
    look.channel = 0;
    look.exposure = 2;
    EXPECT_EQ(describe(rgba, look), QString("Red only · Exposure +2"));
    look = {};
    look.channel = 3;
    look.exposure = -0.5F;
    look.falseColor = true;
    look.marks = true;
    EXPECT_EQ(describe(rgba, look), QString("Opacity only · Exposure −0.5 · False colour · Marks"));
    look = {};
    look.channel = 9; // which it lacks
    EXPECT_EQ(describe(rgba, look), QString());
    look.low = -1;
    EXPECT_EQ(describe(rgba, look), QString("Range -1 to 1"));
}

TEST(LookWords, numbersShownAndMarkedFollowTheLook)
{
    const TexelFormat rgba{TexelType::Half, 4, std::uint16_t{3}};
    Look look;
    EXPECT_EQ(numbersShown(rgba, look).size(), 4U);
    look.opaque = true;
    EXPECT_EQ(numbersShown(rgba, look).size(), 3U);
    look.luminance = true;
    EXPECT_EQ(numbersShown(rgba, look).size(), 1U);
    EXPECT_TRUE(numbersShown(rgba, look).front().weights);
    EXPECT_EQ(numbersMarked(rgba, look).size(), 3U);
    look.channel = 3;
    EXPECT_EQ(numbersShown(rgba, look), (std::vector<TexelNumber>{{3, {}}}));
    EXPECT_EQ(numbersMarked(rgba, look), numbersShown(rgba, look));
}

TEST(ValueAxis, ticksAreRoundAndTellEachOtherApart)
{
    for (const auto& [low, high] : {std::pair(0.0, 1.0),
                                    std::pair(-3.2, 17.0),
                                    std::pair(1000.0, 1000.5),
                                    std::pair(-2e-7, 1e-7),
                                    std::pair(1e30, 4e30)}) {
        for (const int most : {2, 5, 12}) {
            const auto ticks = roundTicks(low, high, most);
            EXPECT_GE(ticks.size(), 1U);
            EXPECT_LE(ticks.size(), static_cast<std::size_t>(most) + 1);
            for (std::size_t k = 0; k < ticks.size(); ++k) {
                const double slack = 1e-6 * (high - low);
                EXPECT_GE(ticks[k].value, low - slack);
                EXPECT_LE(ticks[k].value, high + slack);
                EXPECT_NEAR(ticks[k].text.toDouble(), ticks[k].value, 1e-3 * (high - low));
                EXPECT_TRUE(k == 0 || ticks[k].text != ticks[k - 1].text);
            }
        }
    }
}

} // namespace
} // namespace trixel::ui
