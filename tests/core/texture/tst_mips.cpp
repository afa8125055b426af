// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/lattice/texel.h"
#include "core/texture/mips.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <random>
#include <vector>

using namespace trixel;

namespace {

constexpr TexelType kTypes[]{
    TexelType::UInt8, TexelType::UInt16, TexelType::Half, TexelType::Float};

FaceTexels noise(const TexelFormat& format, Level level, std::uint32_t seed)
{
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> value(0.0F, 1.0F);
    std::vector<float> values(std::size_t{level.texelCount()} * format.channels);
    for (float& v : values) {
        v = value(random);
    }
    std::vector<std::byte> texels(values.size() * byteSize(format.type));
    encode(format.type, values, texels);
    return FaceTexels::full(level, format.texelBytes(), texels);
}

std::vector<float> valuesOf(const TexelFormat& format, std::span<const std::byte> texels)
{
    std::vector<float> values(texels.size() / byteSize(format.type));
    decode(format.type, texels, values);
    return values;
}

/// The four children by lattice position, as the table in the design has them.
std::array<TexelCoord, 4> children(TexelCoord t)
{
    const auto i = static_cast<std::uint16_t>(2 * t.i);
    const auto j = static_cast<std::uint16_t>(2 * t.j);
    const auto i1 = static_cast<std::uint16_t>(i + 1);
    const auto j1 = static_cast<std::uint16_t>(j + 1);
    const auto lower = TexelHalf::Lower;
    const auto upper = TexelHalf::Upper;
    if (t.half == lower) {
        return {TexelCoord{i, j, lower}, {i1, j, lower}, {i, j1, lower}, {i, j, upper}};
    }
    return {TexelCoord{i1, j1, upper}, {i, j1, upper}, {i1, j, upper}, {i1, j1, lower}};
}

} // namespace

TEST(Mips, eachTexelIsTheRoundedMeanOfTheFourItCovers)
{
    for (const TexelType type : kTypes) {
        for (int n = 1; n <= 7; ++n) {
            const TexelFormat format{type, 3, std::nullopt};
            const Level fine(n);
            const FaceTexels face = noise(format, fine, static_cast<std::uint32_t>(n));
            const FaceTexels coarse = reduced(format, face);
            ASSERT_EQ(coarse.level(), Level(n - 1));
            std::vector<float> expected(coarse.bytes().size() / byteSize(type));
            for (std::uint32_t t = 0; t < coarse.level().texelCount(); ++t) {
                const TexelCoord at = texelAt(coarse.level(), TexelIndex{t});
                std::array<double, 3> sum{};
                for (const TexelCoord child : children(at)) {
                    const auto v = valuesOf(format, face.texel(indexOf(texelIndex(fine, child))));
                    for (std::size_t c = 0; c < 3; ++c) {
                        sum[c] += v[c];
                    }
                }
                for (std::size_t c = 0; c < 3; ++c) {
                    double mean = sum[c] / 4;
                    if (type == TexelType::UInt8 || type == TexelType::UInt16) {
                        // Sums of stored integers are whole: quarters are exact, ties go to even.
                        const double top = type == TexelType::UInt8 ? 255 : 65535;
                        mean = std::nearbyint(std::nearbyint(sum[c] * top) / 4) / top;
                    }
                    expected[t * 3 + c] = static_cast<float>(mean);
                }
            }
            std::vector<std::byte> bytes(coarse.bytes().size());
            encode(type, expected, bytes);
            if (type == TexelType::Float) {
                const auto found = valuesOf(format, coarse.bytes());
                for (std::size_t k = 0; k < found.size(); ++k) {
                    ASSERT_NEAR(found[k], expected[k], 2e-7F);
                }
            } else {
                ASSERT_TRUE(std::ranges::equal(coarse.bytes(), bytes))
                    << nameOf(type) << " level " << n;
            }
        }
    }
}

TEST(Mips, sixReductionsDoNotDrift)
{
    // Mean over many faces: half-up rounding drifts +0.8 of a step, truncation -1.9.
    const TexelFormat format{TexelType::UInt8, 1, std::nullopt};
    double drift = 0;
    for (std::uint32_t seed = 0; seed < 40; ++seed) {
        const FaceTexels face = noise(format, Level(6), seed);
        double sum = 0;
        for (const std::byte b : face.bytes()) {
            sum += std::to_integer<int>(b);
        }
        const FaceTexels one = reduced(format, face, 6);
        ASSERT_EQ(one.level(), Level(0));
        drift +=
            std::to_integer<int>(one.bytes()[0]) - sum / static_cast<double>(face.bytes().size());
    }
    EXPECT_LT(std::abs(drift / 40), 0.15);
}

TEST(Mips, aConstantFaceStaysConstantAndStepsStopAtLevelZero)
{
    const std::array<std::byte, 3> red{std::byte{255}, std::byte{1}, std::byte{2}};
    const FaceTexels face = FaceTexels::constant(Level(5), red);
    const FaceTexels coarse = reduced(TexelFormat{}, face, 9);
    EXPECT_TRUE(coarse.isConstant());
    EXPECT_EQ(coarse.level(), Level(0));
    EXPECT_TRUE(std::ranges::equal(coarse.bytes(), red));
    EXPECT_TRUE(coarse.sharesBytesWith(face));
}
