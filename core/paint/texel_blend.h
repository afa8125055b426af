// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/texture/texel_format.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace trixel {

/// How a stroke changes texels, with a the stroke's coverage and c that of the texel, its last
/// channel, where it is one of a layer.
enum class TexelMix : std::uint8_t {
    Towards, ///< all channels: before + a (value - before)
    Over,    ///< on a layer: c' = c + a (1 - c), channels before + a/c' (value - before)
    Uncover  ///< on a layer: c' = c - a c, channels stay
};

/// Moves texels towards one value by their coverage, in float from the texels as they were before
/// the stroke, so that a stroke of many dabs rounds once. Coverage 0 leaves the stored bits alone;
/// coverage 1 stores the value itself, whatever was there.
/// Source of Over, of values not multiplied with their coverage: W3C, Compositing and Blending
/// Level 1, section 5.1.
class TexelBlend
{
public:
    /// \param value  a number per channel, as `encode` takes them; of a layer's coverage it is 1
    /// for Over and 0 for Uncover
    TexelBlend(const TexelFormat& format,
               std::span<const float> value,
               TexelMix mix = TexelMix::Towards);

    const TexelFormat& format() const { return m_format; }

    /// \param before    stored texels, as many as there are coverages
    /// \param coverage  [0,1]
    /// \param texels    receives as many stored texels; may not overlap `before`
    void blend(std::span<const std::byte> before,
               std::span<const float> coverage,
               std::span<std::byte> texels) const;

private:
    TexelFormat m_format;
    TexelMix m_mix;
    std::size_t m_chunk;        ///< texels worked on at a time
    std::vector<float> m_value; ///< the channels' values, repeated for a chunk of texels
};

} // namespace trixel
