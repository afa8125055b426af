// SPDX-License-Identifier: GPL-3.0-or-later
//
// Texels of one face through its levels: each covers exactly the area of four of the next finer
// level, three of its own half and, turned over between them, one of the other.
#pragma once

#include "core/lattice/texel.h"

#include <array>
#include <cstdint>
#include <vector>

namespace trixel {

/// The texel of a coarser level, or of the same, that covers the texel.
/// \param texel   valid at `level` (checked)
/// \param coarse  not above `level` (checked)
TexelCoord ancestorOf(Level level, TexelCoord texel, Level coarse);

/// The texel one level coarser. \param level  at least 1 (checked)
TexelCoord parentOf(Level level, TexelCoord texel);

/// The four texels of the next finer level that it covers: three of its own half, each with a
/// corner of its own, and last the one between them.
/// \param level  of the texel, less than Level::kMax (checked)
std::array<TexelCoord, 4> childrenOf(Level level, TexelCoord texel);

/// Pixels of the packed square side by side in one row.
struct PackedRow
{
    PackedPixel first;
    std::uint16_t count = 0;

    bool operator==(const PackedRow&) const = default;
};

/// Where the packed square of a finer level, or of the same, keeps what the texel covers: the two
/// halves make a staircase each. Every pixel once; 2 · 2^(fine - level) - 1 rows.
/// \param fine  not below `level` (checked)
std::vector<PackedRow> packedDescendants(Level level, TexelCoord texel, Level fine);

} // namespace trixel
