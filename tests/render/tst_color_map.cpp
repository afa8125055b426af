// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/color_map.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

namespace trixel::render {
namespace {

using Linear = std::array<double, 3>;

Linear linear(Rgb color)
{
    Linear result{};
    for (std::size_t c = 0; c < 3; ++c) {
        const double s = color[c] / 255.0;
        result[c] = s <= 0.04045 ? s / 12.92 : std::pow((s + 0.055) / 1.055, 2.4);
    }
    return result;
}

/// CIE lightness, 0 to 100.
double lightness(const Linear& color)
{
    const double y = 0.2126 * color[0] + 0.7152 * color[1] + 0.0722 * color[2];
    return y > 0.008856 ? 116 * std::cbrt(y) - 16 : 903.3 * y;
}

/// What people without one kind of cone see. Source: F. Viénot, H. Brettel, J. Mollon, "Digital
/// video colourmaps for checking the legibility of displays by dichromats", 1999 (red and green).
Linear withoutRed(const Linear& c)
{
    const double x = 0.11238 * c[0] + 0.88762 * c[1];
    return {x, x, 0.00401 * c[0] - 0.00401 * c[1] + c[2]};
}

Linear withoutGreen(const Linear& c)
{
    const double x = 0.29275 * c[0] + 0.70725 * c[1];
    return {x, x, -0.02234 * c[0] + 0.02234 * c[1] + c[2]};
}

TEST(ColorMap, lightnessGrowsEvenly)
{
    constexpr int kSteps = 64;
    std::vector<double> steps;
    double before = lightness(linear(mapColor(0)));
    const double first = before;
    for (int k = 1; k <= kSteps; ++k) {
        const double now = lightness(linear(mapColor(static_cast<double>(k) / kSteps)));
        steps.push_back(now - before);
        before = now;
    }
    EXPECT_LT(first, 20);
    EXPECT_GT(before, 93);
    const double mean = (before - first) / kSteps;
    for (const double step : steps) {
        EXPECT_GT(step, 0.5 * mean);
        EXPECT_LT(step, 1.6 * mean);
    }
}

TEST(ColorMap, staysInOrderForTheColourBlind)
{
    for (const auto seen : {withoutRed, withoutGreen}) {
        double before = -1;
        for (int k = 0; k <= 64; ++k) {
            const double now = lightness(seen(linear(mapColor(k / 64.0))));
            EXPECT_GT(now, before) << k;
            before = now;
        }
    }
}

TEST(ColorMap, numbersOutsideTheScaleGetItsEnds)
{
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    EXPECT_EQ(mapColor(-0.1), mapColor(0));
    EXPECT_EQ(mapColor(-kInfinity), mapColor(0));
    EXPECT_EQ(mapColor(1.1), mapColor(1));
    EXPECT_EQ(mapColor(kInfinity), mapColor(1));
    EXPECT_EQ(mapColor(std::nan("")), kNoNumber);
}

TEST(ColorMap, noColourOfTheScaleMeansNoNumber)
{
    const auto distance = [](Rgb a, Rgb b) {
        int sum = 0;
        for (std::size_t c = 0; c < 3; ++c) {
            sum += std::abs(a[c] - b[c]);
        }
        return sum;
    };
    for (int k = 0; k <= 256; ++k) {
        EXPECT_GT(distance(mapColor(k / 256.0), kNoNumber), 120) << k;
    }
}

} // namespace
} // namespace trixel::render
