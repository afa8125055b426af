// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a .ptx stores beside the texels of a face, where one channel is opacity: reductions are made
// from premultiplied texels, averages are weighted by opacity.
#pragma once

#include "core/texture/texel_format.h"

#include <cstddef>
#include <span>
#include <utility>

namespace trixel {

/// The channels [first, second) that opacity scales: all others if alpha is channel 0, else those
/// before it; none without alpha. Source: the reference library.
std::pair<std::size_t, std::size_t> premultipliedChannels(const TexelFormat& format);

/// Scales the colours of every texel by its opacity; integers are rounded to nearest.
void premultiply(const TexelFormat& format, std::span<std::byte> texels);

/// Divides the colours of every texel by its opacity, where it has any: what `premultiply` was
/// given but for what rounding took.
void unpremultiply(const TexelFormat& format, std::span<std::byte> texels);

/// The mean of the texels, channel by channel, integers rounded to nearest with ties to even. With
/// alpha, colours are weighted by opacity (which leaves the average not premultiplied), unless
/// nothing is opaque.
/// \param average  one texel
void averageTexel(const TexelFormat& format,
                  std::span<const std::byte> texels,
                  std::span<std::byte> average);

} // namespace trixel
