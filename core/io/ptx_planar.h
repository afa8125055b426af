// SPDX-License-Identifier: GPL-3.0-or-later
//
// The two transforms between texels and what a .ptx zips: channels apart from each other, and for
// integers the difference of each value from the one before it.
#pragma once

#include "core/texture/texel_format.h"

#include <cstddef>
#include <span>

namespace trixel {

/// A rectangle of texels inside a packed square.
template <class Byte>
struct TexelWindow
{
    Byte* first = nullptr;   ///< its first texel
    std::size_t columns = 0; ///< texels of a row
    std::size_t rows = 0;
    std::size_t rowStrideBytes = 0; ///< from one row to the next

    std::size_t texelCount() const { return columns * rows; }
};

/// Interleaved texels → channel 0 of all texels, then channel 1, …; with `differences` (uint8 and
/// uint16 only, else ignored) each value becomes its difference from the one before, modulo 2^8 or
/// 2^16, running on from channel to channel.
/// \param planar  as many bytes as the window's texels have
void toPlanar(const TexelFormat& format,
              const TexelWindow<const std::byte>& texels,
              bool differences,
              std::span<std::byte> planar);

/// The inverse.
void fromPlanar(const TexelFormat& format,
                std::span<const std::byte> planar,
                bool differences,
                const TexelWindow<std::byte>& texels);

} // namespace trixel
