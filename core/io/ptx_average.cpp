// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/ptx_average.h"

#include "core/base/check.h"
#include "core/texture/texel_codec.h"

#include <cmath>
#include <cstdint>
#include <limits>
#include <type_traits>
#include <vector>

namespace trixel {

namespace {

template <TexelType kType>
constexpr bool kIsInteger = kType == TexelType::UInt8 || kType == TexelType::UInt16;

// A stored value as a number in its own units: 0 to 255 or 65535 for integers.
template <TexelType kType>
double number(const std::byte* texels, std::size_t index)
{
    using Codec = TexelCodec<kType>;
    const auto stored = loadStored<typename Codec::Stored>(texels, index);
    if constexpr (kIsInteger<kType>) {
        return stored;
    } else {
        return Codec::decoded(stored);
    }
}

template <TexelType kType>
typename TexelCodec<kType>::Stored stored(double value)
{
    using Stored = typename TexelCodec<kType>::Stored;
    if constexpr (kIsInteger<kType>) {
        return static_cast<Stored>(std::nearbyint(value));
    } else {
        return TexelCodec<kType>::encoded(static_cast<float>(value));
    }
}

template <TexelType kType>
void premultiplyAs(const TexelFormat& format, std::span<std::byte> texels)
{
    using Stored = typename TexelCodec<kType>::Stored;
    const auto [first, last] = premultipliedChannels(format);
    const std::size_t texelCount = texels.size() / format.texelBytes();
    for (std::size_t t = 0; t < texelCount; ++t) {
        std::byte* texel = texels.data() + t * format.texelBytes();
        const Stored alpha = loadStored<Stored>(texel, *format.alpha);
        for (std::size_t c = first; c < last; ++c) {
            const Stored colour = loadStored<Stored>(texel, c);
            if constexpr (kIsInteger<kType>) {
                constexpr std::uint64_t kTop = std::numeric_limits<Stored>::max();
                // The divisor is odd, so there are no ties.
                const std::uint64_t product = std::uint64_t{colour} * alpha;
                saveStored(texel, c, static_cast<Stored>((product + kTop / 2) / kTop));
            } else {
                using Codec = TexelCodec<kType>;
                saveStored(
                    texel, c, Codec::encoded(Codec::decoded(colour) * Codec::decoded(alpha)));
            }
        }
    }
}

template <TexelType kType>
double meanOf(const TexelFormat& format, std::span<const std::byte> texels, std::size_t channel)
{
    // Integers add up exactly, and faster.
    std::conditional_t<kIsInteger<kType>, std::uint64_t, double> sum = 0;
    const std::size_t count = texels.size() / byteSize(kType);
    for (std::size_t k = channel; k < count; k += format.channels) {
        if constexpr (kIsInteger<kType>) {
            sum += loadStored<typename TexelCodec<kType>::Stored>(texels.data(), k);
        } else {
            sum += number<kType>(texels.data(), k);
        }
    }
    return static_cast<double>(sum) / static_cast<double>(count / format.channels);
}

template <TexelType kType>
void averageAs(const TexelFormat& format,
               std::span<const std::byte> texels,
               std::span<std::byte> average)
{
    for (std::size_t c = 0; c < format.channels; ++c) {
        saveStored(average.data(), c, stored<kType>(meanOf<kType>(format, texels, c)));
    }
    if (!format.alpha) {
        return;
    }
    const auto [first, last] = premultipliedChannels(format);
    const std::size_t count = texels.size() / byteSize(kType);
    for (std::size_t c = first; c < last; ++c) {
        double weighted = 0;
        double weight = 0;
        for (std::size_t k = 0; k < count; k += format.channels) {
            const double alpha = number<kType>(texels.data(), k + *format.alpha);
            weighted += number<kType>(texels.data(), k + c) * alpha;
            weight += alpha;
        }
        if (weight > 0) {
            saveStored(average.data(), c, stored<kType>(weighted / weight));
        }
    }
}

} // namespace

std::pair<std::size_t, std::size_t> premultipliedChannels(const TexelFormat& format)
{
    if (!format.alpha) {
        return {0, 0};
    }
    return *format.alpha == 0 ? std::pair<std::size_t, std::size_t>{1, format.channels}
                              : std::pair<std::size_t, std::size_t>{0, *format.alpha};
}

void premultiply(const TexelFormat& format, std::span<std::byte> texels)
{
    check(texels.size() % format.texelBytes() == 0, "whole texels");
    if (!format.alpha) {
        return;
    }
    withTexelType(format.type,
                  [&](auto type) { premultiplyAs<decltype(type)::value>(format, texels); });
}

void unpremultiply(const TexelFormat& format, std::span<std::byte> texels)
{
    check(texels.size() % format.texelBytes() == 0, "whole texels");
    if (!format.alpha) {
        return;
    }
    const auto [first, last] = premultipliedChannels(format);
    std::vector<float> values(format.channels);
    for (std::size_t at = 0; at < texels.size(); at += format.texelBytes()) {
        const auto texel = texels.subspan(at, format.texelBytes());
        decode(format.type, texel, values);
        const float alpha = values[*format.alpha];
        if (alpha > 0) {
            for (std::size_t c = first; c < last; ++c) {
                values[c] /= alpha;
            }
            encode(format.type, values, texel);
        }
    }
}

void averageTexel(const TexelFormat& format,
                  std::span<const std::byte> texels,
                  std::span<std::byte> average)
{
    check(!texels.empty() && texels.size() % format.texelBytes() == 0, "whole texels");
    check(average.size() == format.texelBytes(), "room for one texel");
    withTexelType(format.type,
                  [&](auto type) { averageAs<decltype(type)::value>(format, texels, average); });
}

} // namespace trixel
