// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/atlas/atlas_packer.h"

#include <algorithm>

namespace trixel {

std::vector<AtlasGrid> AtlasPacker::place(std::uint32_t count, std::uint32_t side)
{
    check(side > 0 && side <= m_width && side <= m_height, "a tile that a page can hold");
    std::vector<AtlasGrid> grids;
    std::uint32_t placed = 0;
    while (placed < count) {
        // The smallest room that holds a tile: large ones stay whole for as long as possible.
        std::size_t best = m_rooms.size();
        for (std::size_t k = 0; k < m_rooms.size(); ++k) {
            if (m_rooms[k].tiles(side) > 0 &&
                (best == m_rooms.size() || m_rooms[k].tiles(side) < m_rooms[best].tiles(side))) {
                best = k;
            }
        }
        if (best == m_rooms.size()) {
            addPage();
            continue;
        }
        AtlasGrid grid = take(best, count - placed, side);
        grid.first = placed;
        placed += grid.count;
        grids.push_back(grid);
    }
    return grids;
}

/// A grid at the upper left of a room, whose rest is cut in up to three.
AtlasGrid AtlasPacker::take(std::size_t index, std::uint32_t count, std::uint32_t side)
{
    const Room room = m_rooms[index];
    m_rooms.erase(m_rooms.begin() + static_cast<std::ptrdiff_t>(index));
    const std::uint32_t perRow = room.width / side;
    const std::uint32_t most = perRow * (room.height / side);
    const std::uint32_t taken = std::min(count, most);
    const std::uint32_t rows = (taken + perRow - 1) / perRow;
    const std::uint32_t inLast = taken - (rows - 1) * perRow;
    m_ends[room.page] = std::max(m_ends[room.page], room.origin.y + rows * side);

    const auto rest = [&](std::uint32_t x, std::uint32_t y, std::uint32_t w, std::uint32_t h) {
        addRest({room.page, {room.origin.x + x, room.origin.y + y}, w, h});
    };
    rest(0, rows * side, room.width, room.height - rows * side);
    if (m_keepsRests) {
        // Beside the short last row, and beside the whole ones.
        rest(inLast * side, (rows - 1) * side, room.width - inLast * side, side);
        rest(perRow * side, 0, room.width - perRow * side, (rows - 1) * side);
    }
    return {0, taken, perRow, room.page, room.origin};
}

void AtlasPacker::addPage()
{
    m_rooms.push_back({static_cast<std::uint32_t>(m_ends.size()), {}, m_width, m_height});
    m_ends.push_back(0);
}

void AtlasPacker::addRest(const Room& room)
{
    if (room.width > 0 && room.height > 0) {
        m_rooms.push_back(room);
    }
}

std::vector<AtlasPage> AtlasPacker::pages() const
{
    std::vector<AtlasPage> pages;
    for (const std::uint32_t end : m_ends) {
        pages.push_back({m_width, end});
    }
    return pages;
}

} // namespace trixel
