// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/lattice/texel.h"
#include "core/texture/texel_diff.h"
#include "tests/core/cancel_after.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <vector>

using namespace trixel;

namespace {

constexpr TexelFormat kGrey8{TexelType::UInt8, 1, {}};
constexpr TexelFormat kGreyFloat{TexelType::Float, 1, {}};

TexelStore bytes(std::uint32_t faces, Level level, int value)
{
    return {faces, kGrey8, level, std::array{static_cast<std::byte>(value)}};
}

TexelStore floats(std::uint32_t faces, Level level, float value)
{
    return {faces, kGreyFloat, level, std::as_bytes(std::span(&value, 1))};
}

void setFloat(TexelStore& store, FaceId face, std::size_t texel, float value)
{
    const auto texels = store.writable(face);
    encode(TexelType::Float, {&value, 1}, texels.subspan(4 * texel, 4));
}

TexelDiff diff(const TexelStore& a, const TexelStore& b, bool acrossLevels = false)
{
    NoProgress progress;
    auto found =
        diffTexels(DiffSide::of(a), DiffSide::of(b), {.acrossLevels = acrossLevels}, progress);
    EXPECT_TRUE(found.has_value());
    return found.value_or(TexelDiff{});
}

} // namespace

TEST(TexelDiff, equalStoresDifferNowhere)
{
    const TexelStore a = bytes(700, Level(3), 7);
    TexelStore b = a;
    b.writable(FaceId{5}); // spread out, of the same value
    const TexelDiff found = diff(a, b);
    EXPECT_TRUE(found.faces.empty());
    EXPECT_EQ(found.rms, 0);
    EXPECT_EQ(found.psnr(), std::numeric_limits<double>::infinity());
}

TEST(TexelDiff, constantFacesDifferInEveryTexel)
{
    const TexelStore a = bytes(4, Level(3), 0);
    TexelStore b = a;
    b.exchange(FaceId{2}, FaceTexels::constant(Level(3), std::array{std::byte{51}}));
    const TexelDiff found = diff(a, b);
    ASSERT_EQ(found.faces.size(), 1U);
    EXPECT_EQ(found.faces[0].face, FaceId{2});
    EXPECT_EQ(found.faces[0].texels, 64U);
    EXPECT_NEAR(found.faces[0].rms, 0.2, 1e-7);
    EXPECT_NEAR(found.rms, 0.1, 1e-7); // one face of four
    EXPECT_NEAR(found.psnr(), 20, 1e-5);
}

TEST(TexelDiff, facesOfAnotherLevelAreMeasuredOnlyWhenAsked)
{
    const TexelStore a = bytes(2, Level(1), 0);
    TexelStore b = a;
    // At level 2, white in the lower texel of cell (0,0) alone: a quarter of A's texel there.
    b.exchange(FaceId{1}, FaceTexels::constant(Level(2), std::array{std::byte{0}}));
    b.writable(FaceId{1})[0] = std::byte{255};
    const TexelDiff without = diff(a, b);
    EXPECT_EQ(without.levelDifferences, 1U);
    EXPECT_EQ(without.rms, 0);
    EXPECT_EQ(without.faces.at(0).rms, 0);
    const TexelDiff across = diff(a, b, true);
    EXPECT_EQ(across.levelDifferences, 1U);
    EXPECT_EQ(across.faces.at(0).texels, 0U);
    EXPECT_NEAR(across.faces.at(0).rms, 0.25, 1e-12); // one of 16
    EXPECT_NEAR(across.rms, std::sqrt(1.0 / 20), 1e-12);
    EXPECT_EQ(across.maxAbs, 1);
}

TEST(TexelDiff, aFaceMadeFinerByRepeatingItsTexelsIsTheSame)
{
    TexelStore coarse = bytes(1, Level(2), 0);
    const auto texels = coarse.writable(FaceId{0});
    for (std::size_t k = 0; k < texels.size(); ++k) {
        texels[k] = static_cast<std::byte>(3 * k);
    }
    TexelStore fine = bytes(1, Level(4), 0);
    const auto finer = fine.writable(FaceId{0});
    for (std::uint32_t k = 0; k < finer.size(); ++k) {
        const TexelCoord at = texelAt(Level(4), TexelIndex(k));
        finer[k] = texels[indexOf(texelIndex(Level(2), texelAt(Level(2), centroid(Level(4), at))))];
    }
    EXPECT_EQ(diff(coarse, fine, true).rms, 0);
    EXPECT_EQ(diff(fine, coarse, true).levelDifferences, 1U);
}

TEST(TexelDiff, ofFloatsThePeakIsTheSpanOfTheFirst)
{
    TexelStore a = floats(2, Level(1), -1);
    setFloat(a, FaceId{0}, 2, 4);
    setFloat(a, FaceId{1}, 0, std::numeric_limits<float>::infinity());
    TexelStore b = a;
    setFloat(b, FaceId{0}, 0, 100);
    EXPECT_EQ(diff(a, b).peak, 5);
    EXPECT_EQ(diff(floats(2, Level(1), 3), floats(2, Level(1), 3)).peak, 1);
}

TEST(TexelDiff, aNaNEqualsOnlyANaN)
{
    TexelStore a = floats(1, Level(1), 0);
    setFloat(a, FaceId{0}, 1, std::numeric_limits<float>::quiet_NaN());
    TexelStore b = a;
    EXPECT_TRUE(diff(a, b).faces.empty());
    setFloat(b, FaceId{0}, 1, 0);
    EXPECT_EQ(diff(a, b).maxAbs, std::numeric_limits<double>::infinity());
}

TEST(TexelDiff, theAnswerIsTheSameWithAnyNumberOfThreads)
{
    TexelStore a = floats(900, Level(2), 0.5F);
    TexelStore b = a;
    for (std::uint32_t k = 0; k < 900; k += 7) {
        setFloat(b, FaceId{k}, k % 16, 0.001F * static_cast<float>(k));
    }
    NoProgress progress;
    const auto one =
        diffTexels(DiffSide::of(a), DiffSide::of(b), {.threads = Threads{1}}, progress);
    const auto four =
        diffTexels(DiffSide::of(a), DiffSide::of(b), {.threads = Threads{4}}, progress);
    EXPECT_EQ(one->rms, four->rms);
    ASSERT_EQ(one->faces.size(), four->faces.size());
    for (std::size_t k = 0; k < one->faces.size(); ++k) {
        EXPECT_EQ(one->faces[k].face, four->faces[k].face);
        EXPECT_EQ(one->faces[k].rms, four->faces[k].rms);
    }
}

TEST(TexelDiff, othersAreIncomparable)
{
    const TexelStore a = bytes(2, Level(1), 0);
    EXPECT_EQ(incomparable(DiffSide::of(a), DiffSide::of(bytes(3, Level(1), 0))),
              "the first has 2 faces, the second 3");
}

TEST(TexelDiff, comparingCanBeCancelled)
{
    const TexelStore a = bytes(5000, Level(1), 0);
    CancelAfter progress(2);
    const auto found = diffTexels(DiffSide::of(a), DiffSide::of(a), {}, progress);
    ASSERT_FALSE(found.has_value());
    EXPECT_EQ(found.error().kind, ErrorKind::Cancelled);
}
