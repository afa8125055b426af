// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/ptx_planar.h"

#include "core/base/check.h"

#include <cstdint>
#include <cstring>

namespace trixel {

namespace {

template <class T>
T load(const std::byte* from)
{
    T value;
    std::memcpy(&value, from, sizeof(T));
    return value;
}

template <class T>
void store(std::byte* to, T value)
{
    std::memcpy(to, &value, sizeof(T));
}

template <class T, bool Differences>
void toPlanarAs(std::size_t channels, const TexelWindow<const std::byte>& texels, std::byte* planar)
{
    T previous = 0;
    for (std::size_t c = 0; c < channels; ++c) {
        for (std::size_t row = 0; row < texels.rows; ++row) {
            const std::byte* from = texels.first + row * texels.rowStrideBytes + c * sizeof(T);
            for (std::size_t k = 0; k < texels.columns; ++k) {
                const T value = load<T>(from + k * channels * sizeof(T));
                store(planar, Differences ? static_cast<T>(value - previous) : value);
                planar += sizeof(T);
                previous = value;
            }
        }
    }
}

template <class T, bool Differences>
void fromPlanarAs(std::size_t channels,
                  const std::byte* planar,
                  const TexelWindow<std::byte>& texels)
{
    T previous = 0;
    for (std::size_t c = 0; c < channels; ++c) {
        for (std::size_t row = 0; row < texels.rows; ++row) {
            std::byte* to = texels.first + row * texels.rowStrideBytes + c * sizeof(T);
            for (std::size_t k = 0; k < texels.columns; ++k) {
                const T stored = load<T>(planar);
                previous = Differences ? static_cast<T>(previous + stored) : stored;
                store(to + k * channels * sizeof(T), previous);
                planar += sizeof(T);
            }
        }
    }
}

} // namespace

void toPlanar(const TexelFormat& format,
              const TexelWindow<const std::byte>& texels,
              bool differences,
              std::span<std::byte> planar)
{
    check(planar.size() == texels.texelCount() * format.texelBytes(), "room for every texel");
    switch (format.type) {
    case TexelType::UInt8:
        return differences
                   ? toPlanarAs<std::uint8_t, true>(format.channels, texels, planar.data())
                   : toPlanarAs<std::uint8_t, false>(format.channels, texels, planar.data());
    case TexelType::UInt16:
        return differences
                   ? toPlanarAs<std::uint16_t, true>(format.channels, texels, planar.data())
                   : toPlanarAs<std::uint16_t, false>(format.channels, texels, planar.data());
    case TexelType::Half:
        return toPlanarAs<std::uint16_t, false>(format.channels, texels, planar.data());
    case TexelType::Float:
        return toPlanarAs<std::uint32_t, false>(format.channels, texels, planar.data());
    }
}

void fromPlanar(const TexelFormat& format,
                std::span<const std::byte> planar,
                bool differences,
                const TexelWindow<std::byte>& texels)
{
    check(planar.size() == texels.texelCount() * format.texelBytes(), "every texel");
    switch (format.type) {
    case TexelType::UInt8:
        return differences
                   ? fromPlanarAs<std::uint8_t, true>(format.channels, planar.data(), texels)
                   : fromPlanarAs<std::uint8_t, false>(format.channels, planar.data(), texels);
    case TexelType::UInt16:
        return differences
                   ? fromPlanarAs<std::uint16_t, true>(format.channels, planar.data(), texels)
                   : fromPlanarAs<std::uint16_t, false>(format.channels, planar.data(), texels);
    case TexelType::Half:
        return fromPlanarAs<std::uint16_t, false>(format.channels, planar.data(), texels);
    case TexelType::Float:
        return fromPlanarAs<std::uint32_t, false>(format.channels, planar.data(), texels);
    }
}

} // namespace trixel
