// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/color_map.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace trixel::render {

namespace {

constexpr std::size_t kSteps = kMapColors;

/// Lightness and hue along the scale; chroma is as large as the screen's colours allow, up to this.
constexpr double kDarkest = 0.27;
constexpr double kLightest = 0.965;
constexpr double kFirstHue = 285; // degrees in Oklab: violet blue
constexpr double kLastHue = 105;  // yellow
constexpr double kMostChroma = 0.155;

double cube(double x)
{
    return x * x * x; // this is made while the first view waits: `pow` takes ten times as long
}

/// Linear light of an Oklab colour. Source: B. Ottosson, "A perceptual color space for image
/// processing", 2020.
std::array<double, 3> fromOklab(double lightness, double a, double b)
{
    const double l = cube(lightness + 0.3963377774 * a + 0.2158037573 * b);
    const double m = cube(lightness - 0.1055613458 * a - 0.0638541728 * b);
    const double s = cube(lightness - 0.0894841775 * a - 1.2914855480 * b);
    return {4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s,
            -1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s,
            -0.0041960863 * l - 0.7034186147 * m + 1.7076147010 * s};
}

std::uint8_t encoded(double linear)
{
    const double c = std::clamp(linear, 0.0, 1.0);
    const double s = c <= 0.0031308 ? 12.92 * c : 1.055 * std::pow(c, 1 / 2.4) - 0.055;
    return static_cast<std::uint8_t>(std::lround(255 * s));
}

bool isShowable(const std::array<double, 3>& linear)
{
    return std::ranges::all_of(linear, [](double c) { return c >= 0 && c <= 1; });
}

Rgb colorAt(double t)
{
    const double lightness = kDarkest + t * (kLightest - kDarkest);
    const double hue = (kFirstHue + t * (kLastHue - kFirstHue)) * std::numbers::pi / 180;
    double chroma = kMostChroma;
    auto linear = fromOklab(lightness, chroma * std::cos(hue), chroma * std::sin(hue));
    while (!isShowable(linear) && chroma > 0) {
        chroma -= 0.001;
        linear = fromOklab(lightness, chroma * std::cos(hue), chroma * std::sin(hue));
    }
    return {encoded(linear[0]), encoded(linear[1]), encoded(linear[2])};
}

} // namespace

Rgb mapColor(double position)
{
    static const std::array<Rgb, kSteps> kColors = [] {
        std::array<Rgb, kSteps> colors{};
        for (std::size_t k = 0; k < kSteps; ++k) {
            colors[k] = colorAt(static_cast<double>(k) / (kSteps - 1));
        }
        return colors;
    }();
    if (std::isnan(position)) {
        return kNoNumber;
    }
    return kColors[static_cast<std::size_t>(
        std::lround(std::clamp(position, 0.0, 1.0) * (kSteps - 1)))];
}

} // namespace trixel::render
