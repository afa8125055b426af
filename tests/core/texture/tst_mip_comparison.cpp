// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/lattice/texel_family.h"
#include "core/texture/mip_comparison.h"
#include "tests/core/cancel_after.h"

#include <gtest/gtest.h>

#include <random>

using namespace trixel;

namespace {

constexpr TexelFormat kFormat{TexelType::UInt8, 1, std::nullopt};

FaceTexels noise(Level level)
{
    std::mt19937 random(11);
    std::vector<std::byte> texels(level.texelCount());
    for (std::byte& texel : texels) {
        texel = static_cast<std::byte>(random());
    }
    return FaceTexels::full(level, 1, texels);
}

MipComparison comparisonOf(const FaceTexels& face)
{
    NoProgress progress;
    return MipComparison::build(kFormat, face, progress).value();
}

int stored(const FaceTexels& face, std::size_t index)
{
    return std::to_integer<int>(face.texel(index)[0]);
}

} // namespace

TEST(MipComparison, valuesAreThoseOfTheTwoChains)
{
    const FaceTexels face = noise(Level(4));
    const MipComparison comparison = comparisonOf(face);
    ASSERT_EQ(comparison.base(), Level(4));
    FaceTexels right = face;
    FaceTexels box = face;
    const TexelCoord texel{5, 6, TexelHalf::Upper};
    for (int n = 4; n >= 0; --n) {
        const Level level(n);
        const TexelCoord at = ancestorOf(Level(4), texel, level);
        const std::size_t index = indexOf(texelIndex(level, at));
        EXPECT_EQ(comparison.values(face, level, at, ReductionRule::Triangles)[0],
                  static_cast<float>(stored(right, index)) / 255.0F);
        EXPECT_EQ(comparison.values(face, level, at, ReductionRule::Box)[0],
                  static_cast<float>(stored(box, index)) / 255.0F);
        EXPECT_EQ(comparison.difference(level), differenceBetween(kFormat, right, box));
        EXPECT_EQ(comparison.drawn(level, ReductionRule::Triangles), right);
        EXPECT_EQ(comparison.drawn(level, ReductionRule::Box), box);
        if (n > 0) {
            right = reduced(kFormat, right);
            box = reduced(kFormat, box, ReductionRule::Box);
        }
    }
    EXPECT_GT(comparison.worstDifference(), 0);
    EXPECT_EQ(comparison.difference(Level(4)), TexelDifference());
}

TEST(MipComparison, keepsNoneOfTheFacesOwnTexels)
{
    for (const int n : {3, 9}) {
        const FaceTexels face = noise(Level(n));
        const MipComparison comparison = comparisonOf(face);
        for (int k = 0; k <= n; ++k) {
            for (const ReductionRule rule : {ReductionRule::Triangles, ReductionRule::Box}) {
                EXPECT_FALSE(comparison.drawn(Level(k), rule).sharesBytesWith(face));
            }
        }
    }
}

TEST(MipComparison, levelsTooFineToSeeAreDrawnByTheirMeans)
{
    const FaceTexels face = noise(Level(10));
    const MipComparison comparison = comparisonOf(face);
    const FaceTexels box = reduced(kFormat, face, ReductionRule::Box);
    EXPECT_EQ(comparison.at(Level(9), ReductionRule::Box), box);
    EXPECT_EQ(comparison.drawn(Level(10), ReductionRule::Box), reduced(kFormat, face, 2));
    EXPECT_EQ(comparison.drawn(Level(9), ReductionRule::Triangles), reduced(kFormat, face, 2));
    EXPECT_EQ(comparison.drawn(Level(9), ReductionRule::Box), reduced(kFormat, box, 1));
}

TEST(MipComparison, saysWhichLevelsAreOfOneColour)
{
    // From the first reduction on all texels are alike.
    std::vector<std::byte> texels(64);
    for (std::uint32_t t = 0; t < 64; ++t) {
        const TexelCoord at = texelAt(Level(3), TexelIndex{t});
        texels[t] = at.half == TexelHalf::Lower && at.i % 2 == 0 && at.j % 2 == 0 ? std::byte{200}
                                                                                  : std::byte{0};
    }
    // Of each coarse texel's four exactly one must be set: lower (2i,2j) for lower ones.
    for (std::uint32_t t = 0; t < 16; ++t) {
        const TexelCoord coarse = texelAt(Level(2), TexelIndex{t});
        if (coarse.half == TexelHalf::Upper) {
            texels[indexOf(texelIndex(Level(3), childrenOf(Level(2), coarse)[3]))] = std::byte{200};
        }
    }
    const MipComparison comparison = comparisonOf(FaceTexels::full(Level(3), 1, texels));
    EXPECT_FALSE(comparison.isConstant(Level(3)));
    EXPECT_TRUE(comparison.isConstant(Level(2)));
    EXPECT_TRUE(comparison.isConstant(Level(0)));
    EXPECT_GT(comparison.difference(Level(2)).worst, 0) << "the box sees another picture";
}

TEST(MipComparison, aConstantFaceIsConstantAtEveryLevelAndBothAgree)
{
    const std::byte grey{77};
    const FaceTexels face = FaceTexels::constant(Level(12), {&grey, 1});
    const MipComparison comparison = comparisonOf(face);
    for (int n = 0; n <= 12; ++n) {
        EXPECT_TRUE(comparison.isConstant(Level(n)));
        EXPECT_TRUE(comparison.drawn(Level(n), ReductionRule::Box).isConstant());
    }
    EXPECT_EQ(comparison.worstDifference(), 0);
}

TEST(MipComparison, stopsWhereverItIsCancelled)
{
    NoProgress progress;
    int whole = 0;
    for (int reports = 0;; ++reports) {
        CancelAfter soon(reports);
        const auto comparison = MipComparison::build(kFormat, noise(Level(3)), soon);
        if (comparison) {
            whole = reports;
            break;
        }
        EXPECT_EQ(comparison.error().kind, ErrorKind::Cancelled);
    }
    EXPECT_GE(whole, 8);
}
