// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/image/image_sampler.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace trixel {
namespace {

/// One number a pixel, by what makes it.
template <class Value>
Image imageOf(int width, int height, const Value& value, TexelType type = TexelType::Float)
{
    Image image(width, height, {type, 1, std::nullopt}, {ColorSpace::Linear});
    std::vector<float> values;
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            values.push_back(static_cast<float>(value(x, y)));
        }
    }
    encode(type, values, image.writable());
    return image;
}

ImageSampler sampler(Image image,
                     ImageLookup lookup,
                     TableIndex index = TableIndex::Centres,
                     ImageWrap wrap = ImageWrap::Clamp)
{
    return {std::move(image), {0, 0, 0}, {lookup, index, wrap, wrap}, Threads{2}};
}

Footprint square(double side)
{
    return {{side, 0}, {0, side}};
}

constexpr ImageLookup kAll[] = {
    ImageLookup::Nearest, ImageLookup::Bilinear, ImageLookup::Mip, ImageLookup::Footprint};

TEST(ImageSamplerTest, centresAreHalfAPixelFromTheBorder)
{
    // s n - 1/2, t from below.
    const auto at =
        sampler(imageOf(4, 2, [](int x, int y) { return x + 10 * y; }), ImageLookup::Bilinear);
    EXPECT_FLOAT_EQ(at.at({0.125, 0.75}, {}).r, 0);
    EXPECT_FLOAT_EQ(at.at({0.875, 0.25}, {}).r, 13);
    EXPECT_FLOAT_EQ(at.at({0.5, 0.5}, {}).r, 6.5);
    EXPECT_FLOAT_EQ(at.at({0, 1}, {}).r, 0); // clamped
}

TEST(ImageSamplerTest, cornersAreTheImagesCorners)
{
    // s (n - 1), (m - 1)(1 - t).
    const auto at = sampler(imageOf(4, 2, [](int x, int y) { return x + 10 * y; }),
                            ImageLookup::Bilinear,
                            TableIndex::Corners);
    EXPECT_FLOAT_EQ(at.at({0, 1}, {}).r, 0);
    EXPECT_FLOAT_EQ(at.at({1, 0}, {}).r, 13);
    EXPECT_FLOAT_EQ(at.at({1.0 / 3, 1}, {}).r, 1);
    EXPECT_FLOAT_EQ(at.at({0.5, 0.5}, {}).r, 6.5);
}

TEST(ImageSamplerTest, nearestRoundsTheIndexHalfUp)
{
    const auto at = sampler(imageOf(4, 1, [](int x, int) { return x; }), ImageLookup::Nearest);
    EXPECT_EQ(at.at({0.249, 0.5}, {}).r, 0);
    EXPECT_EQ(at.at({0.25, 0.5}, {}).r, 1); // floor(s n - 1/2 + 1/2)
    EXPECT_EQ(at.at({0.999, 0.5}, {}).r, 3);
    EXPECT_EQ(at.at({7, 0.5}, {}).r, 3);
    const auto corners = sampler(
        imageOf(4, 1, [](int x, int) { return x; }), ImageLookup::Nearest, TableIndex::Corners);
    EXPECT_EQ(corners.at({0.16, 0.5}, {}).r, 0);
    EXPECT_EQ(corners.at({0.17, 0.5}, {}).r, 1);
}

TEST(ImageSamplerTest, repeatingGoesOnAcrossTheBorder)
{
    const auto at = sampler(imageOf(4, 4, [](int x, int) { return x; }),
                            ImageLookup::Bilinear,
                            TableIndex::Centres,
                            ImageWrap::Repeat);
    EXPECT_FLOAT_EQ(at.at({0, 0.5}, {}).r, 1.5);
    EXPECT_FLOAT_EQ(at.at({-0.375, 0.5}, {}).r, 2);
    EXPECT_FLOAT_EQ(at.at({5.375, 0.5}, {}).r, 1);
}

TEST(ImageSamplerTest, aConstantStaysItselfWhateverTheFootprint)
{
    for (const ImageLookup lookup : kAll) {
        const auto at = sampler(imageOf(37, 20, [](int, int) { return 0.3; }), lookup);
        for (const double side : {0.0, 1e-6, 0.01, 0.1, 0.7, 5.0, 1e12}) {
            for (const double skew : {0.0, 1.0, 100.0}) {
                const glm::vec4 value =
                    at.at({0.4, 0.6}, {{side, side * skew}, {side * skew, side}});
                EXPECT_NEAR(value.r, 0.3F, 2e-6) << side << ' ' << skew;
                EXPECT_NEAR(value.a, 1, 2e-6);
            }
        }
    }
}

TEST(ImageSamplerTest, anAffineImageKeepsItsValueInTheMiddleOfItsFootprint)
{
    for (const ImageLookup lookup : {ImageLookup::Bilinear, ImageLookup::Footprint}) {
        const auto at =
            sampler(imageOf(256, 256, [](int x, int y) { return 0.01 * x + 0.02 * y; }), lookup);
        std::mt19937 random(3);
        std::uniform_real_distribution<double> any(-1, 1);
        for (int k = 0; k < 200; ++k) {
            const glm::dvec2 st(0.5 + 0.1 * any(random), 0.5 + 0.1 * any(random));
            const double size = std::exp2(-6 + 3 * any(random));
            const Footprint footprint{{size * any(random), size * any(random)},
                                      {size * any(random), size * any(random)}};
            const double expected = 0.01 * (256 * st.x - 0.5) + 0.02 * (256 * (1 - st.y) - 0.5);
            EXPECT_NEAR(at.at(st, footprint).r, expected, 0.012);
        }
    }
}

/// The mean of an image over a triangle of its plane, by brute force.
TEST(ImageSamplerTest, aFootprintAveragesAsMuchAsTheTexelCovers)
{
    // A wave: the Gaussian of the triangle's moments damps it as the triangle does, nearly.
    const auto wave = [](double x, double y) { return std::sin(0.21 * x + 0.13 * y); };
    const auto at = sampler(imageOf(512, 512, wave), ImageLookup::Footprint);
    for (const double texel : {2.0, 6.0, 12.0, 20.0}) {
        const Footprint footprint{{texel / 512, 0}, {0, texel / 512}};
        double sum = 0;
        constexpr int kSteps = 60;
        int count = 0;
        for (int i = 0; i < kSteps; ++i) {
            for (int j = 0; i + j < kSteps; ++j) {
                const double u = (i + 1.0 / 3) / kSteps - 1.0 / 3;
                const double v = (j + 1.0 / 3) / kSteps - 1.0 / 3;
                sum += wave(200 + u * texel, 300 - v * texel);
                ++count;
            }
        }
        const double value = at.at({200.5 / 512, 1 - 300.5 / 512}, footprint).r;
        EXPECT_NEAR(value, sum / count, 0.03) << texel;
    }
}

TEST(ImageSamplerTest, turningTheTexelsCornersChangesNothing)
{
    const auto image = [](int x, int y) {
        return 0.5 + 0.5 * std::sin(0.9 * x) * std::cos(1.1 * y);
    };
    for (const ImageLookup lookup : kAll) {
        const auto at = sampler(imageOf(64, 64, image), lookup);
        const glm::dvec2 w1(0.11, 0.02);
        const glm::dvec2 w2(-0.03, 0.07);
        const float first = at.at({0.3, 0.4}, {w1, w2}).r;
        EXPECT_NEAR(at.at({0.3, 0.4}, {w2 - w1, -w1}).r, first, 1e-5);
        EXPECT_NEAR(at.at({0.3, 0.4}, {w2, w1}).r, first, 1e-5);
    }
}

TEST(ImageSamplerTest, noiseIsAveragedAwayWithoutFlicker)
{
    std::mt19937 random(5);
    std::uniform_real_distribution<double> any(0, 1);
    const auto noise = [&](int, int) { return any(random); };
    const Image image = imageOf(512, 512, noise);
    for (const ImageLookup lookup : {ImageLookup::Mip, ImageLookup::Footprint}) {
        const auto at = sampler(image, lookup);
        for (double s = 0.3; s < 0.7; s += 0.037) {
            EXPECT_NEAR(at.at({s, s}, square(1.0 / 16)).r, 0.5, 0.06);
        }
    }
}

TEST(ImageSamplerTest, longNarrowFootprintsKeepWhatLiesAcrossThem)
{
    // Stripes along s: a footprint 60 times longer than wide blurs along them only.
    const auto stripes = [](int, int y) { return y / 8 % 2; };
    const auto at = sampler(imageOf(512, 512, stripes), ImageLookup::Footprint);
    const Footprint along{{0.2, 0}, {0, 0.004}};
    EXPECT_LT(at.at({0.5, 1 - 4.0 / 512}, along).r, 0.1);
    EXPECT_GT(at.at({0.5, 1 - 12.0 / 512}, along).r, 0.9);
    const auto mip = sampler(imageOf(512, 512, stripes), ImageLookup::Mip);
    EXPECT_NEAR(mip.at({0.5, 1 - 124.0 / 512}, along).r, 0.5, 0.2); // which is what mips do
}

TEST(ImageSamplerTest, bytesAndFloatsOfTheSameImageAgree)
{
    const auto image = [](int x, int y) { return (x * 31 + y * 17) % 256 / 255.0; };
    for (const ImageLookup lookup : kAll) {
        const auto bytes = sampler(imageOf(50, 30, image, TexelType::UInt8), lookup);
        const auto floats = sampler(imageOf(50, 30, image), lookup);
        for (double s = -0.2; s < 1.2; s += 0.11) {
            EXPECT_NEAR(bytes.at({s, 0.3 + 0.3 * s}, square(0.05)).r,
                        floats.at({s, 0.3 + 0.3 * s}, square(0.05)).r,
                        1e-5);
        }
    }
}

TEST(ImageSamplerTest, colorsAreMixedAsLightAndByOpacity)
{
    Image image(2, 1, {TexelType::UInt8, 2, 1}, {ColorSpace::SRgb, ColorSpace::Raw});
    const std::byte pixels[] = {std::byte{255}, std::byte{255}, std::byte{0}, std::byte{255}};
    std::copy(std::begin(pixels), std::end(pixels), image.writable().begin());
    const ImageSampler opaque(image, {0, 0, 0}, {ImageLookup::Bilinear}, Threads{1});
    EXPECT_FLOAT_EQ(opaque.at({0.5, 0.5}, {}).r, 0.5); // half the light
    Image half(2, 1, image.format(), image.colors());
    const std::byte clear[] = {std::byte{255}, std::byte{255}, std::byte{0}, std::byte{0}};
    std::copy(std::begin(clear), std::end(clear), half.writable().begin());
    const ImageSampler weighed(half, {0, 0, 0}, {ImageLookup::Bilinear}, Threads{1});
    const glm::vec4 value = weighed.at({0.5, 0.5}, {});
    EXPECT_FLOAT_EQ(value.r / value.a, 1); // what is clear lends no colour
    EXPECT_FLOAT_EQ(value.a, 0.5);
}

TEST(ImageSamplerTest, wildInputStaysFinite)
{
    const double wild[] = {0, 1e-300, 1e30, 1e300, -1e300, INFINITY, NAN};
    for (const ImageLookup lookup : kAll) {
        for (const ImageWrap wrap : {ImageWrap::Clamp, ImageWrap::Repeat}) {
            const auto at = sampler(imageOf(5, 3, [](int x, int y) { return 0.1 * x + 0.1 * y; }),
                                    lookup,
                                    TableIndex::Centres,
                                    wrap);
            for (const double a : wild) {
                for (const double b : wild) {
                    const glm::vec4 value = at.at({a, b}, {{b, a}, {a, 1}});
                    EXPECT_TRUE(std::isfinite(value.r)) << a << ' ' << b;
                    const glm::vec4 inside = at.at({0.5, 0.5}, {{a, b}, {b, a}});
                    EXPECT_TRUE(std::isfinite(inside.r)) << a << ' ' << b;
                }
            }
        }
    }
}

} // namespace
} // namespace trixel
