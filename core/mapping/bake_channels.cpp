// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mapping/bake_channels.h"

#include "core/base/check.h"

namespace trixel {

BakeChannels::BakeChannels(const TexelFormat& store,
                           const std::vector<ColorSpace>& colors,
                           const std::vector<ColorSpace>& image)
    : m_alpha(store.alpha)
{
    check(colors.empty() || colors.size() == store.channels, "a colour space for each channel");
    check(!image.empty(), "an image with a colour");
    std::uint16_t color = 0;
    for (std::uint16_t c = 0; c < store.channels; ++c) {
        if (store.alpha == c) {
            continue;
        }
        if (image.size() > 1 && color >= image.size()) {
            break;
        }
        const std::uint16_t taken = image.size() > 1 ? color : std::uint16_t{0};
        m_colors.push_back({c, taken, colors.empty() ? image[taken] : colors[c]});
        ++color;
    }
}

void BakeChannels::lay(std::span<const float> colors, float opacity, std::span<float> values) const
{
    const bool covers = opacity >= 1;
    // Where the texel itself is partly transparent, its colour counts as far as it is opaque.
    const float below = m_alpha ? values[*m_alpha] : 1.0F;
    const float whole = opacity + (1 - opacity) * below;
    for (const Channel& channel : m_colors) {
        float& value = values[channel.texel];
        float light = colors[channel.color];
        if (!covers) {
            light += (1 - opacity) * below * toLinear(channel.space, value);
            light = whole > 0 ? light / whole : light;
        }
        value = fromLinear(channel.space, light);
    }
    if (m_alpha) {
        values[*m_alpha] = covers ? 1.0F : whole;
    }
}

} // namespace trixel
