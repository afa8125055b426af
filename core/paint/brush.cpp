// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/paint/brush.h"

#include <array>
#include <cmath>
#include <cstdio>
#include <string>

namespace trixel {

namespace {

std::string shortText(float value)
{
    std::array<char, 32> text{};
    const int length = std::snprintf(text.data(), text.size(), "%.9g", static_cast<double>(value));
    return {text.data(), static_cast<std::size_t>(length)};
}

Status require(bool holds, const char* setting, const char* expected, float found)
{
    if (holds) {
        return {};
    }
    return contentsError(std::string(setting) + ": expected " + expected + ", found " +
                         shortText(found));
}

bool isPart(float value)
{
    return value >= 0.0F && value <= 1.0F; // false for NaN
}

} // namespace

Status validate(const Brush& brush)
{
    constexpr const char* kPart = "a number from 0 to 1";
    const bool sized = brush.radius > 0.0F && std::isfinite(brush.radius);
    const bool spaced = brush.spacing > 0.0F && brush.spacing <= 4.0F;
    Status status = require(sized, "radius", "a finite number above 0", brush.radius);
    const auto next =
        [&status](bool holds, const char* setting, const char* expected, float found) {
            if (status) {
                status = require(holds, setting, expected, found);
            }
        };
    next(isPart(brush.hardness), "hardness", kPart, brush.hardness);
    next(isPart(brush.opacity), "opacity", kPart, brush.opacity);
    next(isPart(brush.flow), "flow", kPart, brush.flow);
    next(spaced, "spacing", "a number above 0 and up to 4", brush.spacing);
    for (const float value : brush.color) {
        next(std::isfinite(value), "color", "finite numbers", value);
    }
    return status;
}

} // namespace trixel
