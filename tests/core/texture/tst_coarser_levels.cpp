// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/lattice/texel.h"
#include "core/texture/coarser_levels.h"
#include "core/texture/mips.h"

#include <gtest/gtest.h>

#include <random>

using namespace trixel;

namespace {

FaceTexels noise(const TexelFormat& format, Level level, unsigned seed)
{
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> any(0, 1);
    std::vector<float> values(std::size_t{level.texelCount()} * format.channels);
    for (float& value : values) {
        value = any(random);
    }
    std::vector<std::byte> bytes(values.size() * byteSize(format.type));
    encode(format.type, values, bytes);
    return FaceTexels::full(level, format.texelBytes(), bytes);
}

void expectAsReduced(const TexelFormat& format, const FaceTexels& face, const CoarserLevels& levels)
{
    ASSERT_EQ(levels.base(), face.level());
    for (int steps = 1; steps <= face.level().log2(); ++steps) {
        EXPECT_EQ(levels.at(face.level().coarser(steps)), reduced(format, face, steps));
    }
}

} // namespace

TEST(CoarserLevels, areThoseThatReducingMakes)
{
    for (const TexelType type :
         {TexelType::UInt8, TexelType::UInt16, TexelType::Half, TexelType::Float}) {
        const TexelFormat format{type, 3, {}};
        for (const Level level : {Level(0), Level(1), Level(5)}) {
            const FaceTexels face = noise(format, level, 7);
            expectAsReduced(format, face, CoarserLevels::of(format, face));
        }
    }
}

TEST(CoarserLevels, followAnyRectangleThatIsPainted)
{
    std::mt19937 random(2);
    for (const TexelType type : {TexelType::UInt8, TexelType::Float}) {
        const TexelFormat format{type, 2, {}};
        const Level level(5);
        FaceTexels face = noise(format, level, 1);
        CoarserLevels levels = CoarserLevels::of(format, face);
        for (unsigned k = 0; k < 60; ++k) {
            TouchedRect rect{};
            rect.x = static_cast<std::uint16_t>(random() % 32);
            rect.y = static_cast<std::uint16_t>(random() % 32);
            rect.width = static_cast<std::uint16_t>(1 + random() % (32U - rect.x));
            rect.height = static_cast<std::uint16_t>(1 + random() % (32U - rect.y));
            const FaceTexels other = noise(format, level, 100 + k);
            const auto bytes = face.writable();
            for (std::size_t y = rect.y; y < std::size_t{rect.y} + rect.height; ++y) {
                for (std::size_t x = rect.x; x < std::size_t{rect.x} + rect.width; ++x) {
                    const auto texel = other.texel(y * 32 + x);
                    std::copy(texel.begin(),
                              texel.end(),
                              bytes.begin() +
                                  static_cast<std::ptrdiff_t>((y * 32 + x) * format.texelBytes()));
                }
            }
            ASSERT_TRUE(levels.canFollow(face, rect));
            levels.update(format, face, rect);
            expectAsReduced(format, face, levels);
        }
    }
}

TEST(CoarserLevels, ofAConstantFaceAreConstantAndCannotFollowPaint)
{
    const TexelFormat format{};
    const std::array texel{std::byte{1}, std::byte{2}, std::byte{3}};
    FaceTexels face = FaceTexels::constant(Level(4), texel);
    const CoarserLevels levels = CoarserLevels::of(format, face);
    EXPECT_TRUE(levels.at(Level(2)).isConstant());
    expectAsReduced(format, face, levels);
    (void)face.writable();
    EXPECT_FALSE(levels.canFollow(face, TouchedRect{.width = 1, .height = 1}));
    const CoarserLevels spread = CoarserLevels::of(format, face);
    EXPECT_TRUE(spread.canFollow(face, TouchedRect{.width = 1, .height = 1}));
    EXPECT_FALSE(spread.canFollow(face, TouchedRect{.wholeFace = true}));
    EXPECT_FALSE(
        spread.canFollow(noise(format, Level(5), 1), TouchedRect{.width = 1, .height = 1}));
}

TEST(SampledAt, takesTexelsFromWithinThoseOfTheCoarserLevel)
{
    const Level fine(6);
    std::vector<float> numbers(fine.texelCount());
    for (std::size_t k = 0; k < numbers.size(); ++k) {
        numbers[k] = static_cast<float>(k);
    }
    const FaceTexels face = FaceTexels::full(fine, 4, std::as_bytes(std::span(numbers)));
    for (const Level level : {Level(0), Level(3), Level(6)}) {
        const FaceTexels sampled = sampledAt(level, face);
        ASSERT_EQ(sampled.level(), level);
        for (std::uint32_t k = 0; k < level.texelCount(); ++k) {
            float number = 0;
            decode(TexelType::Float, sampled.texel(k), std::span(&number, 1));
            const TexelCoord source =
                texelAt(fine, static_cast<TexelIndex>(static_cast<std::uint32_t>(number)));
            EXPECT_EQ(texelIndex(level, texelAt(level, centroid(fine, source))),
                      static_cast<TexelIndex>(k));
        }
    }
}
