// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/atlas/atlas_layout.h"

#include <vector>

namespace trixel {

/// Cuts pages into grids of square tiles, larger tiles first.
class AtlasPacker
{
public:
    /// \param width       of every page
    /// \param height      most of every page
    /// \param keepsRests  what a grid leaves beside it is used by later ones
    AtlasPacker(std::uint32_t width, std::uint32_t height, bool keepsRests)
        : m_width(width)
        , m_height(height)
        , m_keepsRests(keepsRests)
    {
    }

    /// Places so many tiles, on as many pages as it takes.
    /// \param side  of a tile: not above a page's (checked), nor above that of the call before
    std::vector<AtlasGrid> place(std::uint32_t count, std::uint32_t side);

    /// Every page as high as what is on it.
    std::vector<AtlasPage> pages() const;

private:
    /// Room that nothing takes yet.
    struct Room
    {
        std::uint32_t page = 0;
        AtlasPixel origin;
        std::uint32_t width = 0;
        std::uint32_t height = 0;

        std::uint64_t tiles(std::uint32_t side) const
        {
            return std::uint64_t{width / side} * (height / side);
        }
    };

    AtlasGrid take(std::size_t room, std::uint32_t count, std::uint32_t side);
    void addPage();
    void addRest(const Room& room);

    std::uint32_t m_width;
    std::uint32_t m_height;
    bool m_keepsRests;
    std::vector<Room> m_rooms;         ///< rests first used last: the latest are the smallest
    std::vector<std::uint32_t> m_ends; ///< rows used, of each page
};

} // namespace trixel
