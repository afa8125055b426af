// SPDX-License-Identifier: GPL-3.0-or-later
//
// One level coarser: each texel is the mean of the four it covers, by one rule for both halves
// in packed pixels.
#pragma once

#include "core/lattice/texel.h"

#include <array>

namespace trixel {

/// The four texels of `fine` that the pixel of the next coarser level covers:
/// (2x,2y) (2x+1,2y) (2x,2y+1) and (R-1-2y, R-1-2x), with R the resolution of `fine`.
/// \param fine    level of the source, at least 1 (checked)
/// \param coarse  pixel of the packed square at fine.coarser()
constexpr std::array<PackedPixel, 4> finerPixels(Level fine, PackedPixel coarse)
{
    check(fine.log2() >= 1, "a level to reduce");
    const auto last = static_cast<std::uint16_t>(fine.resolution() - 1);
    const auto x = static_cast<std::uint16_t>(2 * coarse.x);
    const auto y = static_cast<std::uint16_t>(2 * coarse.y);
    const auto right = static_cast<std::uint16_t>(x + 1);
    const auto below = static_cast<std::uint16_t>(y + 1);
    return {
        PackedPixel{x, y},
        PackedPixel{right, y},
        PackedPixel{x, below},
        PackedPixel{static_cast<std::uint16_t>(last - y), static_cast<std::uint16_t>(last - x)}};
}

/// What images average instead: the 2 × 2 pixels of the packed square. On the diagonal of the
/// coarser square these are the four that `finerPixels` names; everywhere else (2x+1,2y+1) takes
/// the place of (R-1-2y, R-1-2x): a texel that lies beside the covered area for one inside.
constexpr std::array<PackedPixel, 4> boxPixels(PackedPixel coarse)
{
    const auto x = static_cast<std::uint16_t>(2 * coarse.x);
    const auto y = static_cast<std::uint16_t>(2 * coarse.y);
    const auto right = static_cast<std::uint16_t>(x + 1);
    const auto below = static_cast<std::uint16_t>(y + 1);
    return {
        PackedPixel{x, y}, PackedPixel{right, y}, PackedPixel{x, below}, PackedPixel{right, below}};
}

} // namespace trixel
