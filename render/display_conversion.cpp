// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/display_conversion.h"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <cstring>

namespace trixel::render {

namespace {

constexpr std::uint16_t kHalfOne = 0x3c00;

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

/// \param one  what 1 is stored as
template <class Word>
void wordsShown(const CardChannels& channels,
                std::size_t stride,
                Word one,
                std::span<const std::byte> texels,
                std::byte* shown)
{
    const std::size_t count = texels.size() / (stride * sizeof(Word));
    for (std::size_t c = 0; c < 4; ++c) {
        std::byte* out = shown + c * sizeof(Word);
        const auto channel = static_cast<std::size_t>(std::max(channels[c], 0));
        const std::byte* in = texels.data() + channel * sizeof(Word);
        for (std::size_t k = 0; k < count; ++k) {
            Word word = one;
            if (channels[c] >= 0) {
                std::memcpy(&word, in + k * stride * sizeof(Word), sizeof word);
            }
            std::memcpy(out + k * 4 * sizeof(Word), &word, sizeof word);
        }
    }
}

} // namespace

CardChannels usualChannels(const TexelFormat& format)
{
    const int alpha = format.alpha ? *format.alpha : -1;
    return format.channels < 3 ? CardChannels{0, 0, 0, alpha} : CardChannels{0, 1, 2, alpha};
}

CardChannels channelsFor(const TexelFormat& format, const LookRule& rule)
{
    const CardChannels usual = usualChannels(format);
    const bool isNumber =
        rule.kind != LookRule::Kind::Colors && rule.number != LookRule::kLuminance;
    const int number = rule.number;
    return !isNumber || std::ranges::find(usual, number) != usual.end()
               ? usual
               : CardChannels{number, number, number, -1};
}

void appendShown(const TexelFormat& format,
                 const CardChannels& channels,
                 std::span<const std::byte> texels,
                 std::vector<std::byte>& shown)
{
    const std::size_t count = texels.size() / format.texelBytes();
    const std::size_t before = shown.size();
    shown.resize(before + count * texelBytes(displayFormat(format.type)));
    std::byte* out = shown.data() + before;
    const std::size_t stride = format.channels;
    switch (format.type) {
    case TexelType::UInt8:
        if (stride == 3 && channels == CardChannels{0, 1, 2, -1}) {
            rgbBytesShown(texels, out);
        } else {
            wordsShown<std::uint8_t>(channels, stride, 0xff, texels, out);
        }
        break;
    case TexelType::UInt16:
        wordsShown<std::uint16_t>(channels, stride, 0xffff, texels, out);
        break;
    case TexelType::Half:
        wordsShown<std::uint16_t>(channels, stride, kHalfOne, texels, out);
        break;
    case TexelType::Float:
        wordsShown<std::uint32_t>(
            channels, stride, std::bit_cast<std::uint32_t>(1.0F), texels, out);
        break;
    }
}

void appendShown(const TexelFormat& format,
                 std::span<const std::byte> texels,
                 std::vector<std::byte>& shown)
{
    appendShown(format, usualChannels(format), texels, shown);
}

} // namespace trixel::render
