// SPDX-License-Identifier: GPL-3.0-or-later
//
// Which channel of a texel takes which channel of an image.
#pragma once

#include "core/image/color_space.h"
#include "core/texture/texel_format.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace trixel {

class BakeChannels
{
public:
    /// Colours take colours in their order, and keep what they have where the image has no more; an
    /// image of one colour gives it to all. Opacity becomes that of the image over that of the
    /// texel.
    /// \param store   of the texels
    /// \param colors  what the texels' channels mean, one each; empty: what the image's mean
    /// \param image   what the image's colours mean
    BakeChannels(const TexelFormat& store,
                 const std::vector<ColorSpace>& colors,
                 const std::vector<ColorSpace>& image);

    /// A channel of the texels.
    struct Channel
    {
        std::uint16_t texel = 0; ///< its number
        std::uint16_t color = 0; ///< of the image
        ColorSpace space = ColorSpace::Raw;
    };
    std::span<const Channel> colors() const { return m_colors; }

    /// Lays a pixel over a texel, in linear light.
    /// \param colors   of the image, times its opacity, all of them
    /// \param opacity  [0,1]
    /// \param values   of the texel, as decoded and to be encoded
    void lay(std::span<const float> colors, float opacity, std::span<float> values) const;

private:
    std::vector<Channel> m_colors;
    std::optional<std::uint16_t> m_alpha;
};

} // namespace trixel
