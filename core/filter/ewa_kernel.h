// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/filter/gaussian_window.h"
#include "core/filter/half_lattice.h"
#include "core/filter/query_filter.h"

#include <array>
#include <cstdint>

namespace trixel {

/// Sums over texels under a window: in float over a few thousand of them, in double beyond, for a
/// million floats added up one by one lose four digits.
struct WindowSums
{
    std::array<double, kGroupChannels> values{}; ///< weight times what a texel has beyond the
                                                 ///< reference
    double weight = 0;
    std::uint32_t taps = 0;
};

/// Adds the texels of both halves of a face within the window's cut of the origin, in units of its
/// standard deviation. Runs on the widest vectors that the processor has.
void addUnderWindow(const LevelTexels& texels,
                    const std::array<HalfLattice, 2>& halves,
                    const GaussianWindow& window,
                    const GroupValue& reference,
                    WindowSums& sums);

/// Most texels of a face that are looked at one and all: those of level 2.
inline constexpr std::uint32_t kFewTexels = 16;

/// A face of few texels in the frame of the window.
struct FewTexels
{
    std::uint32_t count = 1;
    const float* u = nullptr; ///< of each centroid, in packed order; readable up to kFewTexels
    const float* v = nullptr;
    glm::vec2 corner{0}, perU{0}, perV{0}; ///< (u,v) lies at corner + u perU + v perV
};

/// The same as `addUnderWindow` without a search for rows.
void addFewUnderWindow(const LevelTexels& texels,
                       const FewTexels& few,
                       const GaussianWindow& window,
                       const GroupValue& reference,
                       WindowSums& sums);

} // namespace trixel
