// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/lattice/reduction.h"
#include "core/lattice/texel_family.h"
#include "core/texture/mip_chain.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

using namespace trixel;

namespace {

constexpr TexelFormat kFloats{TexelType::Float, 2, std::nullopt};

FaceTexels noise(const TexelFormat& format, Level level)
{
    std::mt19937 random(7);
    std::uniform_real_distribution<float> value(0.0F, 1.0F);
    std::vector<float> values(std::size_t{level.texelCount()} * format.channels);
    for (float& v : values) {
        v = value(random);
    }
    std::vector<std::byte> texels(values.size() * byteSize(format.type));
    encode(format.type, values, texels);
    return FaceTexels::full(level, format.texelBytes(), texels);
}

MipChain chainOf(const TexelFormat& format, const FaceTexels& face, ReductionRule rule)
{
    NoProgress progress;
    return MipChain::build(format, face, rule, progress).value();
}

std::vector<float> valuesOf(const TexelFormat& format, const FaceTexels& face, PackedPixel pixel)
{
    std::vector<float> values(format.channels);
    decode(format.type, face.texel(indexOf(texelIndex(face.level(), pixel))), values);
    return values;
}

class CancelAtOnce : public Progress
{
    bool report(double /*fraction*/) override { return false; }
};

} // namespace

TEST(MipChain, holdsEveryLevelEachMadeFromTheFinerOne)
{
    for (const ReductionRule rule : {ReductionRule::Triangles, ReductionRule::Box}) {
        const FaceTexels face = noise({}, Level(5));
        const MipChain chain = chainOf({}, face, rule);
        EXPECT_EQ(chain.base(), Level(5));
        EXPECT_TRUE(chain.at(Level(5)).sharesBytesWith(face));
        for (int n = 4; n >= 0; --n) {
            EXPECT_EQ(chain.at(Level(n)), reduced({}, chain.at(Level(n + 1)), rule));
        }
        EXPECT_EQ(chain.madeBytes(), 3U * (256 + 64 + 16 + 4 + 1));
    }
}

TEST(MipChain, aConstantFaceCostsNothing)
{
    const std::array<std::byte, 3> grey{std::byte{9}, std::byte{9}, std::byte{9}};
    const MipChain chain = chainOf({}, FaceTexels::constant(Level(12), grey), ReductionRule::Box);
    EXPECT_TRUE(chain.at(Level(0)).isConstant());
    EXPECT_EQ(chain.madeBytes(), 0U);
}

TEST(MipChain, stopsWhenCancelled)
{
    CancelAtOnce progress;
    const auto chain = MipChain::build({}, noise({}, Level(3)), ReductionRule::Triangles, progress);
    ASSERT_FALSE(chain);
    EXPECT_EQ(chain.error().kind, ErrorKind::Cancelled);
}

TEST(MipChain, theBoxIsTheMeanOfTwoByTwoPixels)
{
    const FaceTexels face = noise(kFloats, Level(4));
    const FaceTexels coarse = reduced(kFloats, face, ReductionRule::Box);
    for (std::uint16_t y = 0; y < 8; ++y) {
        for (std::uint16_t x = 0; x < 8; ++x) {
            const auto found = valuesOf(kFloats, coarse, {x, y});
            for (std::size_t c = 0; c < 2; ++c) {
                double sum = 0;
                for (int k = 0; k < 4; ++k) {
                    const PackedPixel at{static_cast<std::uint16_t>(2 * x + k % 2),
                                         static_cast<std::uint16_t>(2 * y + k / 2)};
                    sum += static_cast<double>(valuesOf(kFloats, face, at)[c]);
                }
                EXPECT_NEAR(static_cast<double>(found[c]), sum / 4, 1e-6);
            }
        }
    }
}

TEST(MipChain, reductionsAgreeOnTheDiagonalAndDifferByAQuarterOfOneTexelElsewhere)
{
    const Level fine(4);
    const FaceTexels face = noise(kFloats, fine);
    const FaceTexels right = reduced(kFloats, face);
    const FaceTexels box = reduced(kFloats, face, ReductionRule::Box);
    for (std::uint16_t y = 0; y < 8; ++y) {
        for (std::uint16_t x = 0; x < 8; ++x) {
            const float inside = valuesOf(kFloats, face, finerPixels(fine, {x, y})[3])[0];
            const float beside = valuesOf(kFloats, face, boxPixels({x, y})[3])[0];
            const float apart =
                valuesOf(kFloats, box, {x, y})[0] - valuesOf(kFloats, right, {x, y})[0];
            EXPECT_NEAR(apart, (beside - inside) / 4, 1e-6F);
            if (x + y == 7) {
                EXPECT_EQ(apart, 0.0F);
            }
        }
    }
}

TEST(MipChain, theSummedDifferenceIsThatOfTheTexels)
{
    const FaceTexels right = reduced(kFloats, noise(kFloats, Level(5)));
    const FaceTexels box = reduced(kFloats, noise(kFloats, Level(5)), ReductionRule::Box);
    double worst = 0;
    double squares = 0;
    for (std::uint32_t t = 0; t < 256; ++t) {
        const PackedPixel at = packedPixel(Level(4), TexelIndex{t});
        for (std::size_t c = 0; c < 2; ++c) {
            const double apart = static_cast<double>(valuesOf(kFloats, box, at)[c]) -
                                 static_cast<double>(valuesOf(kFloats, right, at)[c]);
            worst = std::max(worst, std::abs(apart));
            squares += apart * apart;
        }
    }
    const TexelDifference found = differenceBetween(kFloats, right, box);
    EXPECT_DOUBLE_EQ(found.worst, worst);
    EXPECT_NEAR(found.rms, std::sqrt(squares / 512), 1e-12);
    EXPECT_EQ(differenceBetween(kFloats, right, right), TexelDifference());
}

TEST(MipChain, aConstantLevelIsComparedTexelByTexelAndWhatIsNotFiniteLeftOut)
{
    const TexelFormat format{TexelType::Float, 1, std::nullopt};
    const float one = 1;
    const FaceTexels ones = FaceTexels::constant(Level(1), std::as_bytes(std::span(&one, 1)));
    const std::array<float, 4> values{1, 4, std::numeric_limits<float>::quiet_NaN(), 1};
    const FaceTexels full =
        FaceTexels::full(Level(1), sizeof(float), std::as_bytes(std::span(values)));
    const TexelDifference found = differenceBetween(format, ones, full);
    EXPECT_EQ(found.worst, 3.0);
    EXPECT_DOUBLE_EQ(found.rms, std::sqrt(3.0));
}
