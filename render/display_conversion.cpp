// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/display_conversion.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>

namespace trixel::render {

namespace {

/// Which channel of the texture each of red, green, blue and opacity shows; -1 is "opaque".
using Channels = std::array<int, 4>;

Channels channelsShown(const TexelFormat& format)
{
    const int alpha = format.alpha ? *format.alpha : -1;
    return format.channels < 3 ? Channels{0, 0, 0, alpha} : Channels{0, 1, 2, alpha};
}

template <class Word>
std::uint8_t toByte(Word value)
{
    if constexpr (sizeof(Word) == 1) {
        return value;
    } else {
        return static_cast<std::uint8_t>((value * 255U + 32767U) / 65535U);
    }
}

/// The common case, with all that is known beforehand left out of the loop.
void rgbBytesShown(std::span<const std::byte> texels, std::byte* shown)
{
    const std::size_t count = texels.size() / 3;
    for (std::size_t k = 0; k < count; ++k) {
        shown[4 * k] = texels[3 * k];
        shown[4 * k + 1] = texels[3 * k + 1];
        shown[4 * k + 2] = texels[3 * k + 2];
        shown[4 * k + 3] = std::byte{255};
    }
}

template <class Word>
void integerShown(const Channels& channels,
                  std::size_t stride,
                  std::span<const std::byte> texels,
                  std::byte* shown)
{
    const std::size_t texelBytes = stride * sizeof(Word);
    const std::size_t count = texels.size() / texelBytes;
    for (std::size_t c = 0; c < 4; ++c) {
        if (channels[c] < 0) {
            for (std::size_t k = 0; k < count; ++k) {
                shown[4 * k + c] = std::byte{255};
            }
            continue;
        }
        const std::byte* in = texels.data() + static_cast<std::size_t>(channels[c]) * sizeof(Word);
        for (std::size_t k = 0; k < count; ++k) {
            Word word;
            std::memcpy(&word, in + k * texelBytes, sizeof word);
            shown[4 * k + c] = static_cast<std::byte>(toByte(word));
        }
    }
}

float showable(float value)
{
    constexpr float kLargestHalf = 65504.0F;
    return std::isnan(value) ? 0.0F : std::clamp(value, -kLargestHalf, kLargestHalf);
}

/// Half and float, a batch at a time through the texture's own decoder.
void floatShown(const TexelFormat& format, std::span<const std::byte> texels, std::byte* shown)
{
    if (texels.empty()) {
        return;
    }
    const Channels channels = channelsShown(format);
    const std::size_t texel = format.texelBytes();
    const std::size_t batch =
        std::clamp<std::size_t>(4096 / format.channels, 1, texels.size() / texel);
    std::vector<float> values(batch * format.channels);
    std::vector<float> out(batch * 4);
    for (std::size_t done = 0; done < texels.size(); done += batch * texel) {
        const auto part = texels.subspan(done, std::min(batch * texel, texels.size() - done));
        const std::size_t count = part.size() / texel;
        decode(format.type, part, std::span(values).first(count * format.channels));
        for (std::size_t k = 0; k < count; ++k) {
            for (std::size_t c = 0; c < 4; ++c) {
                const int channel = channels[c];
                out[4 * k + c] =
                    channel < 0
                        ? 1.0F
                        : showable(values[k * format.channels + static_cast<std::size_t>(channel)]);
            }
        }
        const std::size_t bytes = count * 8;
        encode(TexelType::Half, std::span(out).first(count * 4), {shown, bytes});
        shown += bytes;
    }
}

} // namespace

void appendShown(const TexelFormat& format,
                 std::span<const std::byte> texels,
                 std::vector<std::byte>& shown)
{
    const std::size_t count = texels.size() / format.texelBytes();
    const std::size_t before = shown.size();
    shown.resize(before + count * texelBytes(displayFormat(format.type)));
    std::byte* out = shown.data() + before;
    if (format.type == TexelType::UInt8 && format.channels == 3 && !format.alpha) {
        rgbBytesShown(texels, out);
    } else if (format.type == TexelType::UInt8) {
        integerShown<std::uint8_t>(channelsShown(format), format.channels, texels, out);
    } else if (format.type == TexelType::UInt16) {
        integerShown<std::uint16_t>(channelsShown(format), format.channels, texels, out);
    } else {
        floatShown(format, texels, out);
    }
}

} // namespace trixel::render
