// SPDX-License-Identifier: GPL-3.0-or-later
//
// Texels of a face that is given with its corners in another order.
#pragma once

#include "core/base/level.h"
#include "core/lattice/texel.h"

#include <array>
#include <cstdint>

namespace trixel {

/// Where the corners of a face are in another's order: its corner k is the other's corner order[k].
/// A permutation of 0, 1, 2.
using CornerOrder = std::array<std::uint8_t, 3>;

inline constexpr CornerOrder kSameCorners{0, 1, 2};

/// All six, the turns first, then those that also turn the face over.
inline constexpr std::array<CornerOrder, 6> kCornerOrders{
    CornerOrder{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {2, 1, 0}, {1, 0, 2}};

/// Whether the other face is wound the other way round.
constexpr bool turnsOver(const CornerOrder& order)
{
    return (order[0] + 1) % 3 != order[1];
}

/// The way back.
constexpr CornerOrder inverse(const CornerOrder& order)
{
    CornerOrder back{};
    for (std::uint8_t k = 0; k < 3; ++k) {
        back[order[k]] = k;
    }
    return back;
}

/// The texel of the other face that lies where this one's does: its barycentric coordinates
/// exchanged, which leaves its half as it is.
TexelCoord texelInOrder(Level level, TexelCoord texel, const CornerOrder& order);

} // namespace trixel
