// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/texture/texel_format.h"

#include <cstddef>
#include <span>
#include <vector>

namespace trixel::render {

/// How texels lie on the graphics card: always four channels.
enum class DisplayFormat {
    Rgba8,  ///< for integer textures
    Rgba16F ///< for half and float
};

constexpr DisplayFormat displayFormat(TexelType type)
{
    return type == TexelType::UInt8 || type == TexelType::UInt16 ? DisplayFormat::Rgba8
                                                                 : DisplayFormat::Rgba16F;
}

constexpr std::size_t texelBytes(DisplayFormat format)
{
    return format == DisplayFormat::Rgba8 ? 4 : 8;
}

/// Texels as shown: one or two channels as grey, of more the first three. The fourth channel shown
/// is the opacity channel, or 1 where the format names none. Sixteen-bit integers keep their upper
/// eight bits, rounded; NaN is shown as 0, numbers beyond half as its largest.
/// \param texels  whole texels in `format`
/// \param shown   appended to: `texelBytes(displayFormat(format.type))` a texel
void appendShown(const TexelFormat& format,
                 std::span<const std::byte> texels,
                 std::vector<std::byte>& shown);

} // namespace trixel::render
