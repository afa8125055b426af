// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/paint/texel_blend.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

using namespace trixel;

namespace {

constexpr std::array kTypes{TexelType::UInt8, TexelType::UInt16, TexelType::Half, TexelType::Float};

std::vector<std::byte> encoded(TexelType type, std::span<const float> values)
{
    std::vector<std::byte> texels(values.size() * byteSize(type));
    encode(type, values, texels);
    return texels;
}

std::vector<float> decoded(TexelType type, std::span<const std::byte> texels)
{
    std::vector<float> values(texels.size() / byteSize(type));
    decode(type, texels, values);
    return values;
}

} // namespace

TEST(TexelBlend, everyTypeAndChannelCountMixesByCoverageAndRoundsOnce)
{
    std::mt19937 random(1);
    std::uniform_real_distribution<float> part(0, 1);
    for (const TexelType type : kTypes) {
        for (const int count : {1, 2, 3, 4, 7, 500, 1024}) {
            const auto channels = static_cast<std::uint16_t>(count);
            const std::size_t texels = channels > 100 ? 3 : 333;
            std::vector<float> value(channels);
            std::vector<float> old(texels * channels);
            std::vector<float> coverage(texels);
            for (auto* list : {&value, &old, &coverage}) {
                for (float& v : *list) {
                    v = part(random);
                }
            }
            const auto before = encoded(type, old);
            std::vector<std::byte> after(before.size());
            TexelBlend({type, channels, std::nullopt}, value).blend(before, coverage, after);

            const std::vector<float> from = decoded(type, before);
            std::vector<float> mixed(from.size());
            for (std::size_t k = 0; k < from.size(); ++k) {
                mixed[k] = from[k] + coverage[k / channels] * (value[k % channels] - from[k]);
            }
            ASSERT_EQ(after, encoded(type, mixed)) << nameOf(type) << " x " << channels;
        }
    }
}

TEST(TexelBlend, coverageZeroLeavesTheBitsAloneAndOneStoresTheValue)
{
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const float inf = std::numeric_limits<float>::infinity();
    for (const TexelType type : {TexelType::Half, TexelType::Float}) {
        const auto before = encoded(type, std::array{nan, inf, -inf, 0.3F, nan, inf, -inf, 0.3F});
        std::vector<std::byte> after(before.size());
        const std::array coverage{0.0F, 0.0F, 0.0F, 0.0F, 1.0F, 1.0F, 1.0F, 1.0F};
        const std::array value{0.7F};
        TexelBlend({type, 1, std::nullopt}, value).blend(before, coverage, after);
        const auto expected = encoded(type, std::array{0.7F, 0.7F, 0.7F, 0.7F});
        EXPECT_TRUE(std::equal(before.begin(), before.begin() + 4, after.begin()));
        EXPECT_TRUE(std::equal(expected.begin(),
                               expected.end(),
                               after.begin() + static_cast<std::ptrdiff_t>(expected.size())));
    }
}

TEST(TexelBlend, aTexelOfTheColourItMovesTowardsKeepsItsBits)
{
    std::mt19937 random(2);
    std::uniform_real_distribution<float> part(0, 1);
    for (const TexelType type : kTypes) {
        for (int k = 0; k < 2000; ++k) {
            const auto before = encoded(type, std::array{part(random)});
            const std::vector<float> value = decoded(type, before);
            std::vector<std::byte> after(before.size());
            TexelBlend({type, 1, std::nullopt}, value)
                .blend(before, std::array{part(random)}, after);
            ASSERT_EQ(before, after);
        }
    }
}

TEST(TexelBlend, integersAreClampedAndRoundTiesToEven)
{
    const std::array value{2.0F, -1.0F};
    const auto before = encoded(TexelType::UInt8, std::array{0.0F, 1.0F});
    std::vector<std::byte> after(2);
    TexelBlend({TexelType::UInt8, 2, std::nullopt}, value).blend(before, std::array{0.75F}, after);
    EXPECT_EQ(after[0], std::byte{255});
    EXPECT_EQ(after[1], std::byte{0});
    // 0 towards 5/255 by a half is 2.5 steps: to 2; towards 7/255, 3.5: to 4.
    const std::array ties{5.0F / 255, 7.0F / 255};
    const std::vector<std::byte> black(2);
    TexelBlend({TexelType::UInt8, 2, std::nullopt}, ties).blend(black, std::array{0.5F}, after);
    EXPECT_EQ(after[0], std::byte{2});
    EXPECT_EQ(after[1], std::byte{4});
}

TEST(TexelBlend, onALayerPaintGoesOverWhatItHolds)
{
    std::mt19937 random(3);
    std::uniform_real_distribution<float> part(0, 1);
    for (const TexelType type : kTypes) {
        for (const int channels : {2, 4, 5, 8}) {
            const TexelFormat format{type, static_cast<std::uint16_t>(channels), std::nullopt};
            const auto width = static_cast<std::size_t>(channels);
            std::vector<float> value(width);
            std::vector<float> old(200 * width);
            std::vector<float> coverage(200);
            for (auto* list : {&value, &old, &coverage}) {
                std::ranges::generate(*list, [&] { return part(random); });
            }
            value.back() = 1;
            const auto before = encoded(type, old);
            std::vector<std::byte> after(before.size());
            TexelBlend(format, value, TexelMix::Over).blend(before, coverage, after);
            const std::vector<float> from = decoded(type, before);
            const std::vector<float> to = decoded(type, after);
            for (std::size_t k = 0; k < coverage.size(); ++k) {
                const auto a = static_cast<double>(coverage[k]);
                const auto c = static_cast<double>(from[k * width + width - 1]);
                const double covered = c + a * (1 - c);
                const double step = type == TexelType::UInt8 ? 0.502 / 255 : 0.001;
                EXPECT_NEAR(static_cast<double>(to[k * width + width - 1]), covered, step);
                for (std::size_t n = 0; n + 1 < width; ++n) {
                    const auto v = static_cast<double>(from[k * width + n]);
                    const auto colour = static_cast<double>(value[n]);
                    const double mixed = (v * c * (1 - a) + colour * a) / covered;
                    ASSERT_NEAR(static_cast<double>(to[k * width + n]), mixed, step);
                }
            }
        }
    }
}

TEST(TexelBlend, onALayerTheFirstPaintIsTheColourItselfHoweverThin)
{
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const auto before = encoded(TexelType::Float, std::array{nan, 0.3F, 0.0F});
    std::vector<std::byte> after(before.size());
    const std::array value{0.7F, 0.1F, 1.0F};
    const TexelBlend over({TexelType::Float, 3, 2}, value, TexelMix::Over);
    over.blend(before, std::array{0.01F}, after);
    EXPECT_EQ(after, encoded(TexelType::Float, std::array{0.7F, 0.1F, 0.01F}));
}

TEST(TexelBlend, onALayerNoCoverageLeavesTheBitsAloneAndFullStoresTheColourCovered)
{
    const float nan = std::numeric_limits<float>::quiet_NaN();
    for (const TexelType type : {TexelType::Half, TexelType::Float}) {
        const auto before = encoded(type, std::array{nan, 0.0F, 0.3F, nan, nan, 0.0F, 0.3F, 0.4F});
        const std::array coverage{0.0F, 0.0F, 1.0F, 1.0F};
        std::vector<std::byte> after(before.size());
        const std::array value{0.7F, 1.0F};
        TexelBlend({type, 2, 1}, value, TexelMix::Over).blend(before, coverage, after);
        const auto expected = encoded(type, std::array{0.7F, 1.0F, 0.7F, 1.0F});
        const auto half = static_cast<std::ptrdiff_t>(before.size() / 2);
        EXPECT_TRUE(std::equal(before.begin(), before.begin() + half, after.begin()));
        EXPECT_TRUE(std::equal(expected.begin(), expected.end(), after.begin() + half));
    }
}

TEST(TexelBlend, erasingOnALayerMovesItsCoverageAloneAndEndsAtNone)
{
    for (const TexelType type : kTypes) {
        const auto before = encoded(type, std::array{1.0F, 1.0F, 0.2F, 0.6F, 0.2F, 1.0F});
        std::vector<std::byte> after(before.size());
        const std::array<float, 2> none{};
        TexelBlend({type, 2, 1}, none, TexelMix::Uncover)
            .blend(before, std::array{0.0F, 1.0F, 0.4F}, after);
        EXPECT_EQ(after, encoded(type, std::array{1.0F, 1.0F, 0.2F, 0.0F, 0.2F, 0.6F}));
    }
}
