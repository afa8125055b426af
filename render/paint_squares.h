// SPDX-License-Identifier: GPL-3.0-or-later
//
// Where faces lie in the paint sheet. Plain data, no OpenGL.
#pragma once

#include "core/base/level.h"

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace trixel::render {

/// The square of a face in the sheet: its packed texels, with their first at (x, y).
struct PaintSquare
{
    std::uint16_t x = 0;
    std::uint16_t y = 0;
    Level level;

    bool operator==(const PaintSquare&) const = default;

    /// As the surface's shader reads it, one word a face; 0 stands for a face without a square.
    std::uint32_t word() const
    {
        return kPresent | static_cast<std::uint32_t>(level.log2()) << kLevelShift |
               std::uint32_t{y} << kRowShift | x;
    }
    static PaintSquare of(std::uint32_t word)
    {
        return {static_cast<std::uint16_t>(word & kPlaceMask),
                static_cast<std::uint16_t>(word >> kRowShift & kPlaceMask),
                Level(static_cast<int>(word >> kLevelShift & 0xfU))};
    }

    static constexpr std::uint32_t kPlaceMask = 0x1fff;
    static constexpr int kRowShift = 13;
    static constexpr int kLevelShift = 26;
    static constexpr std::uint32_t kPresent = 0x80000000;
};

/// Lays squares out in a sheet. Squares are as many powers of two as there are levels: each level
/// fills shelves of its own height from the left, so that nothing but the ends of its last shelf is
/// lost. Room comes back all at once.
class PaintSquares
{
public:
    /// Texels along a row of the sheet: the widest square's.
    static constexpr std::uint32_t kWidth = 1U << Level::kMax;
    /// Rows that a square's word can name.
    static constexpr std::uint32_t kMostHeight = 8192;

    /// \param height  rows of the sheet, at most kMostHeight (checked)
    explicit PaintSquares(std::uint32_t height);

    /// Room for one more; nothing when the sheet is full.
    std::optional<PaintSquare> add(Level level);

    /// Rows from the first that hold squares.
    std::uint32_t rowsUsed() const { return m_rows; }

    /// Every square is given back.
    void clear();

private:
    struct Shelf
    {
        std::uint32_t row = 0;
        std::uint32_t used = kWidth; ///< texels from the left; a full one is no shelf
    };

    std::uint32_t m_height;
    std::uint32_t m_rows = 0;
    std::array<Shelf, Level::kMax + 1> m_open; ///< by level: where its next square goes
};

} // namespace trixel::render
