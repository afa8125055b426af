// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/look/look_commands.h"

#include <algorithm>
#include <cmath>

namespace trixel::ui {

render::Look exposed(render::Look look, float by)
{
    look.exposure = std::clamp(look.exposure + by, -kMostStops, kMostStops);
    return look;
}

render::Look ranged(render::Look look, float black, float white)
{
    const float gain = std::exp2(look.exposure);
    const float low = black * gain;
    const float high = white * gain;
    // Their distance must be a number that can be divided by.
    if (std::isfinite(low) && std::isfinite(high) && std::isnormal(high - low) &&
        std::isfinite(1 / (white - black))) {
        look.low = low;
        look.high = high;
    }
    return look;
}

render::Look nextChannel(const TexelFormat& format, render::Look look, int by)
{
    // Colour, the channels, and the luminance of what has colours.
    const bool hasColors = format.channels >= 3;
    const int first = hasColors ? 0 : 1; // of one or two channels the first is shown as it is
    const int channels = format.channels - first;
    const int places = 1 + channels + (hasColors ? 1 : 0);
    int at = 0;
    if (look.channel && *look.channel < format.channels) {
        at = std::max(0, 1 + *look.channel - first);
    } else if (look.luminance && hasColors) {
        at = places - 1;
    }
    at = (at + by + places) % places;
    const bool isChannel = at >= 1 && at <= channels;
    look.channel =
        isChannel ? std::optional(static_cast<std::uint16_t>(at - 1 + first)) : std::nullopt;
    look.luminance = hasColors && at == places - 1;
    return look;
}

} // namespace trixel::ui
