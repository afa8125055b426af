// SPDX-License-Identifier: GPL-3.0-or-later
//
// What probes read: structures of arrays, one place a probe.
#pragma once

#include "core/filter/probe_line.h"

#include <cstddef>
#include <cstdint>

namespace trixel {

/// Probes whose reads are found together, and those of one more query; whole registers. No multiple
/// of 4 KB: a core tells addresses that are apart by that from each other only late.
inline constexpr std::size_t kReadsRoom = kRoomPerLine * (kMostLines + 1) + 80;

/// Probes that lie side by side, whatever line and face they are of.
struct PackedProbes
{
    alignas(64) double u[kReadsRoom]; ///< in texels of the level
    alignas(64) double v[kReadsRoom];
    alignas(64) std::int32_t resolution[kReadsRoom]; ///< of the level
    alignas(64) float weight[kReadsRoom];
};

/// The three vertices that each probe reads at a level: two beside each other in a row of the
/// lattice and one in the row above or below.
struct LevelReads
{
    alignas(64) std::int32_t pair[kReadsRoom]; ///< floats from the probe's values
    alignas(64) std::int32_t single[kReadsRoom];
    alignas(64) float first[kReadsRoom]; ///< weights of the pair's first and second
    alignas(64) float second[kReadsRoom];
    alignas(64) float third[kReadsRoom];
};

/// Two texels of the base that a probe reads.
struct TexelReads
{
    alignas(64) std::int32_t own[kReadsRoom]; ///< packed order
    alignas(64) std::int32_t other[kReadsRoom];
    alignas(64) float ownWeight[kReadsRoom];
    alignas(64) float otherWeight[kReadsRoom];
};

} // namespace trixel
