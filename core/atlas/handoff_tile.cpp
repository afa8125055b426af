// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/atlas/handoff_tile.h"

namespace trixel {

HandOffTile::HandOffTile(std::uint32_t intervals, std::uint32_t padding)
    : m_intervals(static_cast<int>(intervals))
    , m_padding(static_cast<int>(padding))
{
    check(intervals >= 1 && padding >= 1, "a tile of one interval and one pixel of padding");
}

AtlasPixel HandOffTile::pixel(HandOffSlot slot, HandOffSample sample) const
{
    check(holds(sample), "a sample of the tile");
    const int x = sample.i + m_padding;
    const int y = sample.j + m_padding;
    const int last = static_cast<int>(side()) - 1;
    return slot == HandOffSlot::First
               ? AtlasPixel{static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(y)}
               : AtlasPixel{static_cast<std::uint32_t>(last - x),
                            static_cast<std::uint32_t>(last - y)};
}

glm::dvec2 HandOffTile::position(HandOffSlot slot, glm::dvec2 uv) const
{
    const glm::dvec2 at = double(m_intervals) * uv + (m_padding + 0.5);
    return slot == HandOffSlot::First ? at : glm::dvec2(side()) - at;
}

} // namespace trixel
