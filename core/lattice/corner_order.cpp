// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/lattice/corner_order.h"

namespace trixel {

TexelCoord texelInOrder(Level level, TexelCoord texel, const CornerOrder& order)
{
    // Steps towards V0, V1 and V2: they sum up to R-1 in lower texels, to R-2 in upper ones.
    const std::uint32_t sum = level.resolution() - (texel.half == TexelHalf::Lower ? 1 : 2);
    const std::array<std::uint32_t, 3> steps{sum - texel.i - texel.j, texel.i, texel.j};
    std::array<std::uint32_t, 3> there{};
    for (std::size_t k = 0; k < 3; ++k) {
        there[order[k]] = steps[k];
    }
    return {static_cast<std::uint16_t>(there[1]), static_cast<std::uint16_t>(there[2]), texel.half};
}

} // namespace trixel
