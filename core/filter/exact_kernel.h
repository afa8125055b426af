// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/filter/half_lattice.h"
#include "core/filter/query_filter.h"

#include <array>
#include <cstdint>

namespace trixel {

/// Sums over texels in double.
struct ExactSums
{
    std::array<double, kGroupChannels> values{}; ///< weight times value
    double weight = 0;
    std::uint64_t taps = 0;
};

/// Adds the texels of a half lattice within `cut` of the origin with weights
/// exp((offset - distance²)/2) · area. Runs on the widest vectors that the processor has.
void addExactly(const LevelTexels& texels,
                const HalfLattice& lattice,
                double cut,
                double offset,
                double area,
                ExactSums& sums);

} // namespace trixel
