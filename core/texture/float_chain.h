// SPDX-License-Identifier: GPL-3.0-or-later
//
// Four channels of one face as floats: its texels, then every coarser level down to 0, each the
// mean of four without rounding between levels.
#pragma once

#include "core/lattice/texel.h"
#include "core/texture/touched_rect.h"

#include <cstddef>
#include <cstdint>

namespace trixel {

/// Channels are filtered four at a time: one register of floats.
inline constexpr int kGroupChannels = 4;

/// Texels of one face at one level, ready to filter: texel `i` of the packed order begins at
/// values + stride * i and has four channels (those beyond the format's are 0).
struct LevelTexels
{
    const float* values = nullptr;
    std::uint32_t stride = kGroupChannels; ///< 0 where the face is constant

    const float* texel(TexelIndex index) const { return values + stride * indexOf(index); }
};

/// Floats before a level: finer ones come first, from the base down to level 0.
constexpr std::size_t chainBegin(Level base, Level level)
{
    return kGroupChannels *
           ((4 * std::size_t{base.texelCount()} - 4 * std::size_t{level.texelCount()}) / 3);
}

/// Floats of all levels; of a constant face those of one texel.
constexpr std::size_t chainSize(Level base, bool constant)
{
    return kGroupChannels + (constant ? 0 : chainBegin(base, Level(0)));
}

/// Fills the levels below the base, whose texels are there.
void fillCoarser(Level base, float* values);

/// Makes the parents of touched texels anew. \return how many
std::size_t updateCoarser(Level base, const TouchedRect& rect, float* values);

} // namespace trixel
