// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

namespace trixel {

/// How one channel of a texel is stored; the numbers are those of the .ptx header.
enum class TexelType : std::uint8_t { UInt8 = 0, UInt16 = 1, Half = 2, Float = 3 };

/// Bytes of one channel.
constexpr std::size_t byteSize(TexelType type)
{
    switch (type) {
    case TexelType::UInt8:
        return 1;
    case TexelType::UInt16:
    case TexelType::Half:
        return 2;
    case TexelType::Float:
        break;
    }
    return 4;
}

/// "uint8", "uint16", "half", "float": as the command line and the window write them.
std::string_view nameOf(TexelType type);
std::optional<TexelType> texelTypeFromName(std::string_view name);

/// What every texel of a store holds: channels, interleaved, all of one type.
struct TexelFormat
{
    static constexpr int kMaxChannels = 1024;

    TexelType type = TexelType::UInt8;
    std::uint16_t channels = 3;
    /// Channel that is opacity, or nothing.
    std::optional<std::uint16_t> alpha;

    std::size_t texelBytes() const { return byteSize(type) * channels; }

    bool operator==(const TexelFormat&) const = default;
};

/// Texel values as stored → numbers: integers in [0,1], half and float as they are.
/// \param texels  a whole number of channel values
/// \param values  as many floats
void decode(TexelType type, std::span<const std::byte> texels, std::span<float> values);

/// Numbers → stored values: integers clamped to [0,1] and rounded to nearest, ties to even
/// (NaN becomes 0), half rounded to nearest even, float as it is.
void encode(TexelType type, std::span<const float> values, std::span<std::byte> texels);

} // namespace trixel
