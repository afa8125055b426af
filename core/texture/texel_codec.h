// SPDX-License-Identifier: GPL-3.0-or-later
//
// One stored channel value ↔ one number, known at compile time: for inner loops that must not ask
// for the type at every texel.
#pragma once

#include "core/texture/texel_format.h"

#include <Imath/half.h>
#include <cstdint>
#include <cstring>
#include <type_traits>

namespace trixel {

namespace detail {

/// Nearest integer, ties to even, for |x| < 2^22 under the default rounding mode; unlike
/// std::nearbyint it is two additions and lets loops run several values at a time.
inline float roundedToEven(float x)
{
    constexpr float kShift = 12582912.0F; // 1.5 * 2^23: the next float is one away
    return (x + kShift) - kShift;
}

/// \return  [0,1] spread over the integers of T; NaN gives 0
template <class T>
T quantised(float value)
{
    constexpr float kTop = static_cast<float>(static_cast<T>(~T{0}));
    const float scaled = value * kTop;
    const float low = scaled > 0.0F ? scaled : 0.0F; // false for NaN
    const float clamped = low < kTop ? low : kTop;
    return static_cast<T>(static_cast<std::int32_t>(roundedToEven(clamped)));
}

} // namespace detail

/// `Stored` as it lies in memory, and its two conversions; see `decode` and `encode`.
template <TexelType>
struct TexelCodec;

template <>
struct TexelCodec<TexelType::UInt8>
{
    using Stored = std::uint8_t;
    static float decoded(Stored value) { return static_cast<float>(value) / 255.0F; }
    static Stored encoded(float value) { return detail::quantised<Stored>(value); }
};

template <>
struct TexelCodec<TexelType::UInt16>
{
    using Stored = std::uint16_t;
    static float decoded(Stored value) { return static_cast<float>(value) / 65535.0F; }
    static Stored encoded(float value) { return detail::quantised<Stored>(value); }
};

template <>
struct TexelCodec<TexelType::Half>
{
    using Stored = std::uint16_t;
    static float decoded(Stored value) { return imath_half_to_float(value); }
    static Stored encoded(float value) { return imath_float_to_half(value); }
};

template <>
struct TexelCodec<TexelType::Float>
{
    using Stored = float;
    static float decoded(Stored value) { return value; }
    static Stored encoded(float value) { return value; }
};

/// Calls work(std::integral_constant<TexelType, type>) and returns what it returns.
template <class Work>
auto withTexelType(TexelType type, Work&& work)
{
    switch (type) {
    case TexelType::UInt8:
        return work(std::integral_constant<TexelType, TexelType::UInt8>{});
    case TexelType::UInt16:
        return work(std::integral_constant<TexelType, TexelType::UInt16>{});
    case TexelType::Half:
        return work(std::integral_constant<TexelType, TexelType::Half>{});
    case TexelType::Float:
        break;
    }
    return work(std::integral_constant<TexelType, TexelType::Float>{});
}

/// Stored value number `index` of a byte array of any alignment.
template <class T>
T loadStored(const std::byte* bytes, std::size_t index)
{
    T value;
    std::memcpy(&value, bytes + index * sizeof(T), sizeof(T));
    return value;
}

template <class T>
void saveStored(std::byte* bytes, std::size_t index, T value)
{
    std::memcpy(bytes + index * sizeof(T), &value, sizeof(T));
}

} // namespace trixel
