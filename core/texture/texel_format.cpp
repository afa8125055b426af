// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/texture/texel_format.h"

#include "core/base/check.h"
#include "core/texture/texel_codec.h"

#include <array>

namespace trixel {

namespace {

constexpr std::array<std::string_view, 4> kTypeNames{"uint8", "uint16", "half", "float"};

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
    withTexelType(type, [&](auto constant) {
        using Codec = TexelCodec<decltype(constant)::value>;
        for (std::size_t k = 0; k < values.size(); ++k) {
            values[k] = Codec::decoded(loadStored<typename Codec::Stored>(texels.data(), k));
        }
    });
}

void encode(TexelType type, std::span<const float> values, std::span<std::byte> texels)
{
    check(texels.size() == values.size() * byteSize(type), "one number a stored value");
    withTexelType(type, [&](auto constant) {
        using Codec = TexelCodec<decltype(constant)::value>;
        for (std::size_t k = 0; k < values.size(); ++k) {
            saveStored(texels.data(), k, Codec::encoded(values[k]));
        }
    });
}

} // namespace trixel
