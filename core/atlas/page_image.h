// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/atlas/atlas_layout.h"
#include "core/texture/texel_format.h"

#include <cstddef>
#include <glm/vec2.hpp>
#include <span>
#include <vector>

namespace trixel {

/// Pixels of one page, row by row from the top.
struct PageImage
{
    AtlasPage size;
    TexelFormat format;
    std::vector<std::byte> pixels;

    std::span<std::byte> at(AtlasPixel pixel)
    {
        return std::span(pixels).subspan(offset(pixel), format.texelBytes());
    }
    std::span<const std::byte> at(AtlasPixel pixel) const
    {
        return std::span(pixels).subspan(offset(pixel), format.texelBytes());
    }

    /// What hardware shows at a place: the four nearest pixels, interpolated, those of the page's
    /// border repeated. Pixel centres are at 1/2.
    /// \param value  a float a channel
    void bilinear(glm::dvec2 place, std::span<float> value) const;

private:
    std::size_t offset(AtlasPixel pixel) const
    {
        return (std::size_t{pixel.y} * size.width + pixel.x) * format.texelBytes();
    }
};

} // namespace trixel
