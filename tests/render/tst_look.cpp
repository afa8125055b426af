// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/color_map.h"
#include "render/texel_shader.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <random>
#include <vector>

namespace trixel::render {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();
const float kNan = std::nanf("");

const TexelFormat kColors{TexelType::Float, 3, {}};
const TexelFormat kWithOpacity{TexelType::Float, 4, std::uint16_t{3}};
const TexelFormat kSingle{TexelType::Float, 1, {}};

Rgba shaded(const TexelFormat& format, std::vector<float> values, const Look& look = {})
{
    return shade(format, values, look);
}

Rgba grey(std::uint8_t level)
{
    return {level, level, level, 255};
}

Rgba mapped(double position)
{
    const Rgb color = mapColor(position);
    return {color[0], color[1], color[2], 255};
}

TEST(Look, theNeutralOneShowsValuesAsTheyAre)
{
    EXPECT_EQ(shaded(kColors, {0, 0.5F, 1}), (Rgba{0, 128, 255, 255}));
    EXPECT_EQ(shaded(kColors, {-1, 2, kNan}), (Rgba{0, 255, 0, 255}));
    EXPECT_EQ(shaded(kSingle, {0.2F}), grey(51));
    EXPECT_EQ(shaded(kWithOpacity, {0, 1, 0, 0.2F}), (Rgba{0, 255, 0, 51}));
    EXPECT_EQ(shaded({TexelType::Float, 2, std::uint16_t{1}}, {1, 0.2F}),
              (Rgba{255, 255, 255, 51}));
}

TEST(Look, aStopOfExposureDoublesValuesBeforeTheRange)
{
    Look look;
    look.exposure = 1;
    EXPECT_EQ(shaded(kSingle, {0.25F}, look), grey(128));
    look.low = 0.5F;
    EXPECT_EQ(shaded(kSingle, {0.25F}, look), grey(0));
    EXPECT_EQ(shaded(kSingle, {0.5F}, look), grey(255));
    EXPECT_EQ(look.blackValue(), 0.25F);
    EXPECT_EQ(look.whiteValue(), 0.5F);
}

TEST(Look, anInvertedRangeShowsSmallValuesBright)
{
    Look look;
    look.low = 1;
    look.high = 0;
    EXPECT_EQ(shaded(kSingle, {0.2F}, look), grey(204));
}

TEST(Look, aNarrowRangeFarFromZeroKeepsItsSteps)
{
    Look look;
    look.low = 1000;
    look.high = 1000.5F;
    for (int k = 0; k <= 10; ++k) {
        const float value = 1000.0F + 0.05F * static_cast<float>(k);
        const int level = shaded(kSingle, {value}, look)[0];
        EXPECT_NEAR(level, 25.5 * k, 0.6) << k;
    }
}

TEST(Look, anyChannelIsShownAloneAsOpaqueGrey)
{
    const TexelFormat six{TexelType::Float, 6, std::uint16_t{3}};
    const std::vector<float> values{0, 0.2F, 0.4F, 0.6F, 0.8F, 1};
    Look look;
    for (std::uint16_t c = 0; c < 6; ++c) {
        look.channel = c;
        EXPECT_EQ(shaded(six, values, look), grey(static_cast<std::uint8_t>(51 * c)));
    }
    look.channel = 6; // which it lacks
    EXPECT_EQ(shaded(six, values, look), shaded(six, values));
}

TEST(Look, luminanceWeighsTheFirstThreeChannels)
{
    Look look;
    look.luminance = true;
    EXPECT_EQ(shaded(kColors, {1, 1, 1}, look), grey(255));
    EXPECT_EQ(shaded(kColors, {1, 0, 0}, look), grey(54));
    EXPECT_EQ(shaded(kColors, {0, 1, 0}, look), grey(182));
    EXPECT_EQ(shaded(kWithOpacity, {0, 0, 1, 0.1F}, look), grey(18));
    EXPECT_EQ(shaded(kSingle, {0.2F}, look), grey(51));
}

TEST(Look, falseColourShowsTheNumberOnTheScale)
{
    Look look;
    look.falseColor = true;
    look.high = 2;
    EXPECT_EQ(shaded(kSingle, {0.5F}, look), mapped(0.25));
    EXPECT_EQ(shaded(kColors, {1, 1, 1}, look), mapped(0.5));
    look.channel = 1;
    EXPECT_EQ(shaded(kColors, {0, 2, 0}, look), mapped(1));
    EXPECT_EQ(shaded(kColors, {0, -kInfinity, 0}, look), mapped(0));
    EXPECT_EQ(shaded(kColors, {0, kNan, 0}, look),
              (Rgba{kNoNumber[0], kNoNumber[1], kNoNumber[2], 255}));
}

TEST(Look, opacityCanBeLeftOut)
{
    Look look;
    look.opaque = true;
    EXPECT_EQ(shaded(kWithOpacity, {0, 1, 0, 0.2F}, look), (Rgba{0, 255, 0, 255}));
}

TEST(Look, marksNameTheWorstOfTheChannelsShown)
{
    Look look;
    const auto of = [&](std::vector<float> values) {
        return markOf(values.size() == 4 ? kWithOpacity : kColors, values, look);
    };
    EXPECT_EQ(of({0, 1, 0.5F}), Mark::None);
    EXPECT_EQ(of({-0.0F, 1, 0.5F}), Mark::None);
    EXPECT_EQ(of({0, 1.001F, 0.5F}), Mark::Clipped);
    EXPECT_EQ(of({-1e-30F, 2, 0.5F}), Mark::Negative);
    EXPECT_EQ(of({-1, 2, -kInfinity}), Mark::Infinite);
    EXPECT_EQ(of({kNan, -1, kInfinity}), Mark::NotANumber);
    EXPECT_EQ(of({0, 0, 0, kNan}), Mark::NotANumber);
    EXPECT_EQ(of({0, 0, 0, 1.5F}), Mark::Clipped);
    look.channel = 1;
    EXPECT_EQ(of({kNan, 0.5F, kInfinity, -1}), Mark::None);
    look.channel.reset();
    look.opaque = true;
    EXPECT_EQ(of({0, 0, 0, kNan}), Mark::None);
}

TEST(Look, clippedMeansAboveTheRangeAsExposed)
{
    Look look;
    look.exposure = 2;
    look.high = 2;
    EXPECT_EQ(markOf(kSingle, std::vector<float>{0.5F}, look), Mark::None);
    EXPECT_EQ(markOf(kSingle, std::vector<float>{0.501F}, look), Mark::Clipped);
    std::swap(look.low, look.high);
    EXPECT_EQ(markOf(kSingle, std::vector<float>{0.501F}, look), Mark::Clipped);
}

TEST(Look, marksAreShownOnlyWhenAskedFor)
{
    Look look;
    EXPECT_EQ(shaded(kSingle, {2}, look), grey(255));
    look.marks = true;
    EXPECT_EQ(shaded(kSingle, {2}, look), markColor(Mark::Clipped));
    EXPECT_EQ(shaded(kSingle, {1}, look), grey(255));
}

using Linear = std::array<double, 3>;

Linear linear(Rgba color)
{
    Linear result{};
    for (std::size_t c = 0; c < 3; ++c) {
        const double s = color[c] / 255.0;
        result[c] = s <= 0.04045 ? s / 12.92 : std::pow((s + 0.055) / 1.055, 2.4);
    }
    return result;
}

/// What is seen by all eyes and by those without one kind of cone, in parts of 255. Source:
/// F. Viénot, H. Brettel, J. Mollon, "Digital video colourmaps for checking the legibility of
/// displays by dichromats", 1999.
std::array<Linear, 3> seen(Rgba color)
{
    const Linear c = linear(color);
    const double red = 0.11238 * c[0] + 0.88762 * c[1];
    const double green = 0.29275 * c[0] + 0.70725 * c[1];
    std::array<Linear, 3> eyes{c,
                               Linear{red, red, 0.00401 * c[0] - 0.00401 * c[1] + c[2]},
                               Linear{green, green, -0.02234 * c[0] + 0.02234 * c[1] + c[2]}};
    for (Linear& eye : eyes) {
        for (double& part : eye) {
            part = 255 * std::pow(std::clamp(part, 0.0, 1.0), 1 / 2.2);
        }
    }
    return eyes;
}

TEST(Look, marksDifferForEveryEye)
{
    for (const Mark a : kMarks) {
        for (const Mark b : kMarks) {
            for (std::size_t eye = 0; a < b && eye < 3; ++eye) {
                const Linear x = seen(markColor(a))[eye];
                const Linear y = seen(markColor(b))[eye];
                double most = 0;
                for (std::size_t c = 0; c < 3; ++c) {
                    most = std::max(most, std::abs(x[c] - y[c]));
                }
                EXPECT_GT(most, 60) << int(a) << " " << int(b) << " eye " << eye;
            }
        }
    }
}

TEST(Look, marksDifferByTheirPatternsToo)
{
    for (const Mark a : kMarks) {
        int ink = 0;
        for (int k = 0; k < 256; ++k) {
            ink += hasInk(a, k % 16 - 8, k / 16 - 8) ? 1 : 0;
        }
        EXPECT_GT(ink, 80) << int(a);
        EXPECT_LT(ink, 140) << int(a);
        for (const Mark b : kMarks) {
            int differing = 0;
            for (int k = 0; a != b && k < 256; ++k) {
                differing += hasInk(a, k % 16, k / 16) != hasInk(b, k % 16, k / 16) ? 1 : 0;
            }
            EXPECT_TRUE(a == b || differing > 60) << int(a) << " " << int(b);
        }
    }
}

std::vector<Look> manyLooks()
{
    std::vector<Look> looks;
    for (int k = 0; k < 96; ++k) {
        Look look;
        if (const int channel = k % 6; channel > 0) {
            look.channel = static_cast<std::uint16_t>(channel - 1);
        }
        look.falseColor = k % 4 == 1;
        look.luminance = k % 5 == 2;
        look.marks = k % 3 == 1;
        look.opaque = k % 7 == 3;
        look.exposure = static_cast<float>(k % 11 - 5) * 0.7F;
        look.low = static_cast<float>(k % 9) * 0.1F - 0.3F;
        look.high = k % 8 == 7 ? look.low - 1 : look.low + 0.4F + static_cast<float>(k % 3);
        looks.push_back(look);
    }
    return looks;
}

TEST(TexelShader, agreesWithShadeForEveryTypeAndLook)
{
    std::mt19937 random(7);
    std::uniform_real_distribution<float> in(-0.4F, 1.6F);
    for (const TexelType type :
         {TexelType::UInt8, TexelType::UInt16, TexelType::Half, TexelType::Float}) {
        for (std::uint16_t channels = 1; channels <= 5; ++channels) {
            TexelFormat format{type, channels, {}};
            if (channels % 2 == 0) {
                format.alpha = static_cast<std::uint16_t>(channels - 1);
            }
            constexpr std::size_t kTexels = 1500; // more than a batch of five channels
            std::vector<float> values(kTexels * channels);
            std::ranges::generate(values, [&] { return in(random); });
            values[3] = kNan;
            values[8] = kInfinity;
            values[12] = -kInfinity;
            std::vector<std::byte> texels(kTexels * format.texelBytes());
            encode(type, values, texels);
            decode(type, texels, values);
            std::vector<Rgba> colors(kTexels);
            for (const Look& look : manyLooks()) {
                const TexelShader shader(format, look);
                shader(texels, colors);
                for (std::size_t k = 0; k < kTexels; ++k) {
                    const auto texel = std::span(values).subspan(k * channels, channels);
                    ASSERT_EQ(colors[k], shade(format, texel, look)) << k;
                    ASSERT_EQ(colors[k], shader(texel)) << k;
                }
            }
        }
    }
}

} // namespace
} // namespace trixel::render
