// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/texture/texel_format.h"

#include <cstddef>
#include <span>
#include <vector>

namespace trixel {

/// Moves texels towards one value by their coverage: before + coverage (value - before), in float
/// from the texels as they were before the stroke, so that a stroke of many dabs rounds once.
/// Coverage 0 leaves the stored bits alone; coverage 1 stores the value itself, whatever was there.
class TexelBlend
{
public:
    /// \param value  a number per channel, as `encode` takes them
    TexelBlend(const TexelFormat& format, std::span<const float> value);

    /// \param before    stored texels, as many as there are coverages
    /// \param coverage  [0,1]
    /// \param texels    receives as many stored texels; may not overlap `before`
    void blend(std::span<const std::byte> before,
               std::span<const float> coverage,
               std::span<std::byte> texels) const;

private:
    TexelFormat m_format;
    std::size_t m_chunk;        ///< texels worked on at a time
    std::vector<float> m_value; ///< the channels' values, repeated for a chunk of texels
};

} // namespace trixel
