// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/image/image_levels.h"

#include <gtest/gtest.h>

#include <array>
#include <cstring>
#include <random>

namespace trixel {
namespace {

Image floatImage(int width,
                 int height,
                 const std::vector<float>& values,
                 std::uint16_t channels = 1)
{
    TexelFormat format{TexelType::Float, channels, std::nullopt};
    if (channels == 4) {
        format.alpha = 3;
    }
    Image image(width, height, format, uniformColors(ColorSpace::Linear, channels, format.alpha));
    encode(TexelType::Float, values, image.writable());
    return image;
}

std::vector<float> valuesOf(const Image& image)
{
    std::vector<float> values(image.byteCount() / byteSize(image.format().type));
    decode(image.format().type, image.pixels(), values);
    return values;
}

TEST(ImageLevelsTest, halvingKeepsTheMeanAtEverySize)
{
    std::mt19937 random(7);
    std::uniform_real_distribution<float> any(0, 1);
    for (const auto& [width, height] : {std::pair(8, 8), {7, 5}, {13, 1}, {3, 9}, {2, 3}}) {
        std::vector<float> values(static_cast<std::size_t>(width * height));
        double mean = 0;
        for (float& value : values) {
            value = any(random);
            mean += value / static_cast<double>(values.size());
        }
        for (const Image& level : imageLevels(floatImage(width, height, values), Threads{2})) {
            double sum = 0;
            for (const float value : valuesOf(level)) {
                sum += value;
            }
            EXPECT_NEAR(sum / (level.width() * level.height()), mean, 1e-6)
                << width << "x" << height << " at " << level.width();
        }
    }
}

TEST(ImageLevelsTest, levelsEndAtOnePixelAndRoundDown)
{
    const auto levels = imageLevels(floatImage(9, 4, std::vector<float>(36, 1.0F)), Threads{1});
    ASSERT_EQ(levels.size(), 4U);
    EXPECT_EQ(levels[1].width(), 4);
    EXPECT_EQ(levels[1].height(), 2);
    EXPECT_EQ(levels[3].width(), 1);
    EXPECT_EQ(levels[3].height(), 1);
}

TEST(ImageLevelsTest, sRgbIsAveragedAsLight)
{
    Image image(2, 1, {TexelType::UInt8, 1, std::nullopt}, {ColorSpace::SRgb});
    image.writable()[1] = std::byte{255};
    const Image half = halved(image, Threads{1});
    EXPECT_EQ(std::to_integer<int>(half.pixels()[0]), 188); // 0.5 of the light
}

/// Of two pixels of three channels and opacity.
void expectHalf(const std::vector<float>& pixels, const std::array<float, 4>& expected)
{
    const auto values = valuesOf(halved(floatImage(2, 1, pixels, 4), Threads{1}));
    for (std::size_t c = 0; c < expected.size(); ++c) {
        EXPECT_FLOAT_EQ(values[c], expected[c]) << c;
    }
}

TEST(ImageLevelsTest, whatIsTransparentLendsNoColor)
{
    expectHalf({0.8F, 0.1F, 0, 1, 0, 9, 9, 0}, {0.8F, 0.1F, 0, 0.5F});
}

/// They are there for programs that look up colours on their own.
TEST(ImageLevelsTest, hiddenColorsHaveAMeanWhereNothingIsSeen)
{
    expectHalf({0.8F, 0.2F, 0, 0, 0.4F, 0.2F, 1, 0}, {0.6F, 0.2F, 0.5F, 0});
}

TEST(ImageLevelsTest, threadsDoNotChangeTheResult)
{
    std::vector<float> values(61 * 47);
    for (std::size_t k = 0; k < values.size(); ++k) {
        values[k] = static_cast<float>((k * 2654435761U) % 1000) / 999;
    }
    const Image image = floatImage(61, 47, values);
    EXPECT_EQ(valuesOf(halved(image, Threads{1})), valuesOf(halved(image, Threads{3})));
}

} // namespace
} // namespace trixel
