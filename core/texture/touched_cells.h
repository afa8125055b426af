// SPDX-License-Identifier: GPL-3.0-or-later
//
// Which cells of the lattice a touched rectangle of the packed square means, level by level.
#pragma once

#include "core/base/level.h"
#include "core/texture/touched_rect.h"

#include <array>
#include <cstddef>
#include <cstdint>

namespace trixel {

/// Cells i in [i0, i1], j in [j0, j1] of the lattice, both texels of each. Cells beyond the
/// hypotenuse are no cells.
struct CellRect
{
    std::uint32_t i0 = 0, j0 = 0, i1 = 0, j1 = 0;

    /// The cells one level coarser that cover these: parents of both texels are in cell (i/2, j/2).
    CellRect coarser() const { return {i0 / 2, j0 / 2, i1 / 2, j1 / 2}; }
    bool contains(const CellRect& other) const
    {
        return i0 <= other.i0 && j0 <= other.j0 && i1 >= other.i1 && j1 >= other.j1;
    }
    bool operator==(const CellRect&) const = default;
};

/// The rectangle's lower texels are in one rectangle of cells, its upper ones in another.
struct TouchedCells
{
    std::size_t count = 0;
    std::array<CellRect, 2> rects{};

    TouchedCells(Level level, const TouchedRect& rect);
    TouchedCells coarser() const;

private:
    TouchedCells() = default;
    void add(const CellRect& rect);
};

inline void TouchedCells::add(const CellRect& rect)
{
    if (count == 1 && rects[0].contains(rect)) {
        return;
    }
    if (count == 1 && rect.contains(rects[0])) {
        rects[0] = rect;
        return;
    }
    rects[count++] = rect;
}

inline TouchedCells::TouchedCells(Level level, const TouchedRect& rect)
{
    const std::uint32_t r = level.resolution();
    if (rect.wholeFace) {
        add({0, 0, r - 1, r - 1});
        return;
    }
    if (rect.width == 0 || rect.height == 0 || rect.x >= r || rect.y >= r) {
        return;
    }
    const std::uint32_t x0 = rect.x;
    const std::uint32_t y0 = rect.y;
    const std::uint32_t x1 = x0 + rect.width > r ? r - 1 : x0 + rect.width - 1;
    const std::uint32_t y1 = y0 + rect.height > r ? r - 1 : y0 + rect.height - 1;
    if (x0 + y0 < r) {
        add({x0, y0, x1, y1});
    }
    if (x1 + y1 >= r) {
        add({r - 1 - y1, r - 1 - x1, r - 1 - y0, r - 1 - x0});
    }
}

inline TouchedCells TouchedCells::coarser() const
{
    TouchedCells parents;
    for (std::size_t k = 0; k < count; ++k) {
        parents.add(rects[k].coarser());
    }
    return parents;
}

} // namespace trixel
