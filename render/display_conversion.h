// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/texture/texel_format.h"
#include "render/look.h"

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace trixel::render {

/// How texels lie on the graphics card: always four channels, of the texture's own type, so that
/// every value arrives there to the bit, NaN and infinite ones included.
enum class DisplayFormat {
    Rgba8,   ///< uint8
    Rgba16,  ///< uint16
    Rgba16F, ///< half
    Rgba32F  ///< float
};

constexpr DisplayFormat displayFormat(TexelType type)
{
    switch (type) {
    case TexelType::UInt8:
        return DisplayFormat::Rgba8;
    case TexelType::UInt16:
        return DisplayFormat::Rgba16;
    case TexelType::Half:
        return DisplayFormat::Rgba16F;
    case TexelType::Float:
        break;
    }
    return DisplayFormat::Rgba32F;
}

constexpr std::size_t texelBytes(DisplayFormat format)
{
    switch (format) {
    case DisplayFormat::Rgba8:
        return 4;
    case DisplayFormat::Rgba16:
    case DisplayFormat::Rgba16F:
        return 8;
    case DisplayFormat::Rgba32F:
        break;
    }
    return 16;
}

/// Which channels of the texture the four on the card hold; -1 holds 1.
using CardChannels = std::array<int, 4>;

/// Of one or two channels the first three times, of more the first three; then opacity.
CardChannels usualChannels(const TexelFormat& format);
/// The usual ones, unless the look shows a number that is not among them: then that alone.
CardChannels channelsFor(const TexelFormat& format, const LookRule& rule);

/// Texels as they lie on the card.
/// \param texels  whole texels in `format`
/// \param shown   appended to: `texelBytes(displayFormat(format.type))` a texel
void appendShown(const TexelFormat& format,
                 const CardChannels& channels,
                 std::span<const std::byte> texels,
                 std::vector<std::byte>& shown);
/// The same with the usual channels.
void appendShown(const TexelFormat& format,
                 std::span<const std::byte> texels,
                 std::vector<std::byte>& shown);

} // namespace trixel::render
