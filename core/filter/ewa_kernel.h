// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/filter/gaussian_window.h"
#include "core/filter/placed_face.h"
#include "core/filter/query_filter.h"

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

namespace trixel {

/// Sums over texels under a window, each weighted by the window and its area. In float over a few
/// hundred of them, in double beyond, for a million floats added up one by one lose four digits.
struct WindowSums
{
    std::array<double, kGroupChannels> values{}; ///< weight times what a texel has beyond the
                                                 ///< reference
    double weight = 0;
    std::uint64_t taps = 0;
};

/// What a mip level has averaged already, for one face: the covariance of a triangle with its
/// sides, times this, is what a texel of the level spreads beyond one of the base.
inline float spreadShare(Level base, Level level)
{
    // Each level a quarter of the one before.
    const auto texel = [](Level of) {
        return std::bit_cast<float>((127U - 2U * static_cast<unsigned>(of.log2())) << 23U);
    };
    return (texel(level) - texel(base)) * (1.0F / 18);
}

/// The finest level of which all texels of a face are looked at, without a search for rows.
inline constexpr int kFewLevel = 3;

/// Faces of few texels, of one level, in the ellipse's unit frame: as arrays, to be looked at side
/// by side. Left as they are made: what lies beyond `count` is not read into any answer.
struct FewFaces
{
    static constexpr std::uint32_t kRoom = 64;

    std::uint32_t count;
    std::array<float, kRoom> originX, originY, e1X, e1Y, e2X, e2Y;
    std::array<float, kRoom> share; ///< `spreadShare`
    std::array<const float*, kRoom> texels;
    std::array<std::uint32_t, kRoom> stride; ///< as `LevelTexels` has it
};

/// Adds the texels of the faces within the window's cut. The covariance of the ellipse is lessened
/// by that of a texel's box beyond a base texel's, so that box and Gaussian together spread as far
/// as the Gaussian alone over the base level; by half at most. Weights are of equal mass whatever
/// was subtracted. Runs on the widest vectors that the processor has.
/// \param level  of all of them, at most kFewLevel
void addFewUnderWindow(const FewFaces& faces,
                       int level,
                       const GaussianWindow& window,
                       const GroupValue& reference,
                       WindowSums& sums);

/// The same for a face of any size, row by row.
/// \param base  level of the face; `level` is not above it
void addUnderWindow(const LevelTexels& texels,
                    Level base,
                    Level level,
                    const PlacedFace& place,
                    const GaussianWindow& window,
                    const GroupValue& reference,
                    WindowSums& sums);

} // namespace trixel
