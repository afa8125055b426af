// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/atlas/atlas_tile.h"

namespace trixel {

AtlasPixel AtlasTile::pixel(LatticeCell cell) const
{
    const int last = static_cast<int>(side()) - 1;
    const int i = cell.i + m_border;
    const int j = cell.j + m_border;
    const bool isLower = cell.half == TexelHalf::Lower;
    check(i >= 0 && j >= 0 && i + j + (isLower ? 0 : 1) <= last, "a cell of the tile");
    return isLower ? AtlasPixel{static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(j)}
                   : AtlasPixel{static_cast<std::uint32_t>(last - j),
                                static_cast<std::uint32_t>(last - i)};
}

LatticeCell AtlasTile::cell(AtlasPixel pixel) const
{
    check(pixel.x < side() && pixel.y < side(), "a pixel of the tile");
    const int last = static_cast<int>(side()) - 1;
    const int x = static_cast<int>(pixel.x);
    const int y = static_cast<int>(pixel.y);
    return x + y <= last ? LatticeCell{x - m_border, y - m_border, TexelHalf::Lower}
                         : LatticeCell{last - y - m_border, last - x - m_border, TexelHalf::Upper};
}

glm::dvec2 AtlasTile::position(glm::dvec2 uv, TexelHalf half) const
{
    // Centroids lie a third of a cell from the lower texel's corner, two thirds for the upper one;
    // pixel centres half a pixel: hence the sixth of the paint projection.
    constexpr double kSixth = 1.0 / 6.0;
    const glm::dvec2 cells = double(m_resolution) * uv;
    return half == TexelHalf::Lower
               ? cells + (kSixth + m_border)
               : glm::dvec2(side() + kSixth - m_border) - glm::dvec2(cells.y, cells.x);
}

} // namespace trixel
