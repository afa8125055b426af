// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/texture/texel_format.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstring>
#include <limits>

using namespace trixel;

namespace {

template <class T>
T encodeOne(TexelType type, float value)
{
    std::array<std::byte, sizeof(T)> bytes{};
    encode(type, std::array{value}, bytes);
    T stored;
    std::memcpy(&stored, bytes.data(), sizeof(T));
    return stored;
}

template <class T>
float decodeOne(TexelType type, T stored)
{
    std::array<std::byte, sizeof(T)> bytes{};
    std::memcpy(bytes.data(), &stored, sizeof(T));
    std::array<float, 1> value{};
    decode(type, bytes, value);
    return value[0];
}

} // namespace

TEST(TexelFormat, everyStoredIntegerSurvivesARoundTrip)
{
    for (unsigned k = 0; k < 256; ++k) {
        const auto v = static_cast<std::uint8_t>(k);
        EXPECT_EQ(encodeOne<std::uint8_t>(TexelType::UInt8, decodeOne(TexelType::UInt8, v)), v);
    }
    for (unsigned k = 0; k < 65536; ++k) {
        const auto v = static_cast<std::uint16_t>(k);
        ASSERT_EQ(encodeOne<std::uint16_t>(TexelType::UInt16, decodeOne(TexelType::UInt16, v)), v);
    }
}

TEST(TexelFormat, everyHalfSurvivesARoundTripNaNsAsNaNs)
{
    for (unsigned k = 0; k < 65536; ++k) {
        const auto bits = static_cast<std::uint16_t>(k);
        const float value = decodeOne(TexelType::Half, bits);
        const auto back = encodeOne<std::uint16_t>(TexelType::Half, value);
        if (std::isnan(value)) {
            ASSERT_TRUE(std::isnan(decodeOne(TexelType::Half, back)));
        } else {
            ASSERT_EQ(back, bits);
        }
    }
}

TEST(TexelFormat, integersClampAndRoundTiesToEven)
{
    EXPECT_EQ(encodeOne<std::uint8_t>(TexelType::UInt8, -1.0F), 0);
    EXPECT_EQ(encodeOne<std::uint8_t>(TexelType::UInt8, 7.0F), 255);
    EXPECT_EQ(encodeOne<std::uint8_t>(TexelType::UInt8, std::nanf("")), 0);
    EXPECT_EQ(encodeOne<std::uint8_t>(TexelType::UInt8, std::numeric_limits<float>::infinity()),
              255);
    EXPECT_EQ(encodeOne<std::uint8_t>(TexelType::UInt8, 0.5F), 128); // 127.5 → even
}

TEST(TexelFormat, namesAreReadBack)
{
    for (TexelType type :
         {TexelType::UInt8, TexelType::UInt16, TexelType::Half, TexelType::Float}) {
        EXPECT_EQ(texelTypeFromName(nameOf(type)), type);
    }
    EXPECT_FALSE(texelTypeFromName("double").has_value());
}
