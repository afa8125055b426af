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

/// The finest level of which all texels of a face are looked at, without a search for rows.
inline constexpr int kFewExactLevel = 3;

/// Faces of few texels, of one level, in the ellipse's unit frame: as arrays, to be looked at side
/// by side.
struct FewExactFaces
{
    static constexpr std::uint32_t kRoom = 32;

    std::uint32_t count;
    std::array<double, kRoom> originX, originY, e1X, e1Y, e2X, e2Y;
    std::array<const float*, kRoom> texels;
    std::array<std::uint32_t, kRoom> stride; ///< as `LevelTexels` has it
};

/// The same for every texel of those faces, `area` being each one's own.
/// \param level  of all of them, at most kFewExactLevel
void addFewExactly(
    const FewExactFaces& faces, int level, double cut, double offset, ExactSums& sums);

} // namespace trixel
