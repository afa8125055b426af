// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/image/color_space.h"

#include <gtest/gtest.h>

#include <cmath>

namespace trixel {
namespace {

TEST(ColorSpaceTest, theCurveIsThatOfTheStandard)
{
    EXPECT_FLOAT_EQ(toLinear(ColorSpace::SRgb, 0.0F), 0.0F);
    EXPECT_FLOAT_EQ(toLinear(ColorSpace::SRgb, 1.0F), 1.0F);
    EXPECT_NEAR(toLinear(ColorSpace::SRgb, 0.5F), 0.21404114F, 1e-6);
    EXPECT_NEAR(toLinear(ColorSpace::SRgb, 0.04F), 0.04F / 12.92F, 1e-8);
}

TEST(ColorSpaceTest, thereAndBackIsTheSameForEveryByte)
{
    for (int k = 0; k < 256; ++k) {
        const float stored = static_cast<float>(k) / 255;
        const float back = fromLinear(ColorSpace::SRgb, toLinear(ColorSpace::SRgb, stored));
        EXPECT_EQ(std::lround(back * 255), k);
    }
}

TEST(ColorSpaceTest, theCurveGoesOnBeyondItsEnds)
{
    for (const float stored : {-0.5F, -0.01F, 1.5F, 20.0F}) {
        EXPECT_NEAR(fromLinear(ColorSpace::SRgb, toLinear(ColorSpace::SRgb, stored)),
                    stored,
                    1e-5 * std::abs(stored));
    }
    EXPECT_TRUE(std::isnan(toLinear(ColorSpace::SRgb, NAN)));
    EXPECT_TRUE(std::isnan(fromLinear(ColorSpace::SRgb, NAN)));
}

TEST(ColorSpaceTest, rawAndLinearNumbersStay)
{
    EXPECT_EQ(toLinear(ColorSpace::Raw, 0.3F), 0.3F);
    EXPECT_EQ(fromLinear(ColorSpace::Linear, 0.3F), 0.3F);
}

TEST(ColorSpaceTest, textNamesEveryChannel)
{
    const std::vector<ColorSpace> spaces = {ColorSpace::SRgb, ColorSpace::Linear, ColorSpace::Raw};
    EXPECT_EQ(toText(spaces), "srgb,linear,raw");
    EXPECT_EQ(colorSpacesFromText("srgb,linear,raw"), spaces);
    for (const char* wrong : {"", ",", "srgb,", "srgb,SRGB", "rgb"}) {
        EXPECT_FALSE(colorSpacesFromText(wrong)) << wrong;
    }
}

TEST(ColorSpaceTest, opacityIsNoColor)
{
    EXPECT_EQ(toText(uniformColors(ColorSpace::SRgb, 4, 3)), "srgb,srgb,srgb,raw");
    EXPECT_EQ(toText(uniformColors(ColorSpace::SRgb, 2, std::nullopt)), "srgb,srgb");
}

} // namespace
} // namespace trixel
