// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/paint_squares.h"

#include "core/base/check.h"

namespace trixel::render {

PaintSquares::PaintSquares(std::uint32_t height)
    : m_height(height)
{
    check(height <= kMostHeight, "a height that squares can name");
}

std::optional<PaintSquare> PaintSquares::add(Level level)
{
    const std::uint32_t side = level.resolution();
    Shelf& shelf = m_open[static_cast<std::size_t>(level.log2())];
    if (shelf.used + side > kWidth) {
        if (m_rows + side > m_height) {
            return std::nullopt;
        }
        shelf = {m_rows, 0};
        m_rows += side;
    }
    const PaintSquare square{
        static_cast<std::uint16_t>(shelf.used), static_cast<std::uint16_t>(shelf.row), level};
    shelf.used += side;
    return square;
}

void PaintSquares::clear()
{
    m_rows = 0;
    m_open.fill({});
}

} // namespace trixel::render
