// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/look.h"

#include "core/base/check.h"

#include <cmath>

namespace trixel::render {

namespace {

std::uint8_t toByte(float part)
{
    const float inside = part >= 0.0F ? std::fmin(part, 1.0F) : 0.0F; // NaN becomes 0
    return static_cast<std::uint8_t>(std::lround(inside * 255.0F));
}

} // namespace

Rgba shade(const TexelFormat& format, std::span<const float> values, const Look& look)
{
    check(values.size() == format.channels, "a value a channel");
    const float gain = std::exp2(look.exposure);
    const auto shown = [&](std::size_t channel) {
        return toByte((values[channel] * gain - look.low) / (look.high - look.low));
    };
    if (look.channel || format.channels < 3) {
        const std::uint8_t grey = shown(look.channel.value_or(0));
        return {grey, grey, grey, 255};
    }
    const std::uint8_t opacity = format.alpha ? toByte(values[*format.alpha]) : std::uint8_t{255};
    return {shown(0), shown(1), shown(2), opacity};
}

} // namespace trixel::render
