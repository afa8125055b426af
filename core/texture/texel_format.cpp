// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/texture/texel_format.h"

#include "core/base/check.h"

#include <Imath/half.h>
#include <array>
#include <cmath>
#include <cstring>

namespace trixel {

namespace {

constexpr std::array<std::string_view, 4> kTypeNames{"uint8", "uint16", "half", "float"};

template <class T>
T load(const std::byte* bytes)
{
    T value;
    std::memcpy(&value, bytes, sizeof(T));
    return value;
}

template <class T>
T quantise(float value)
{
    constexpr float kTop = static_cast<float>(static_cast<T>(~T{0}));
    const float scaled = value * kTop;
    if (!(scaled > 0.0F)) {
        return 0;
    }
    return scaled >= kTop ? static_cast<T>(~T{0}) : static_cast<T>(std::nearbyint(scaled));
}

template <class T, class Convert>
void decodeAs(std::span<const std::byte> texels, std::span<float> values, Convert convert)
{
    for (std::size_t k = 0; k < values.size(); ++k) {
        values[k] = convert(load<T>(texels.data() + k * sizeof(T)));
    }
}

template <class T, class Convert>
void encodeAs(std::span<const float> values, std::span<std::byte> texels, Convert convert)
{
    for (std::size_t k = 0; k < values.size(); ++k) {
        const T stored = convert(values[k]);
        std::memcpy(texels.data() + k * sizeof(T), &stored, sizeof(T));
    }
}

} // namespace

std::string_view nameOf(TexelType type)
{
    return kTypeNames[static_cast<std::size_t>(type)];
}

std::optional<TexelType> texelTypeFromName(std::string_view name)
{
    for (std::size_t k = 0; k < kTypeNames.size(); ++k) {
        if (kTypeNames[k] == name) {
            return static_cast<TexelType>(k);
        }
    }
    return std::nullopt;
}

void decode(TexelType type, std::span<const std::byte> texels, std::span<float> values)
{
    check(texels.size() == values.size() * byteSize(type), "one number a stored value");
    switch (type) {
    case TexelType::UInt8:
        return decodeAs<std::uint8_t>(texels, values, [](auto v) { return float(v) / 255.0F; });
    case TexelType::UInt16:
        return decodeAs<std::uint16_t>(texels, values, [](auto v) { return float(v) / 65535.0F; });
    case TexelType::Half:
        return decodeAs<std::uint16_t>(
            texels, values, [](auto bits) { return imath_half_to_float(bits); });
    case TexelType::Float:
        std::memcpy(values.data(), texels.data(), texels.size());
        return;
    }
}

void encode(TexelType type, std::span<const float> values, std::span<std::byte> texels)
{
    check(texels.size() == values.size() * byteSize(type), "one number a stored value");
    switch (type) {
    case TexelType::UInt8:
        return encodeAs<std::uint8_t>(values, texels, quantise<std::uint8_t>);
    case TexelType::UInt16:
        return encodeAs<std::uint16_t>(values, texels, quantise<std::uint16_t>);
    case TexelType::Half:
        return encodeAs<std::uint16_t>(
            values, texels, [](float v) { return imath_float_to_half(v); });
    case TexelType::Float:
        std::memcpy(texels.data(), values.data(), texels.size());
        return;
    }
}

} // namespace trixel
