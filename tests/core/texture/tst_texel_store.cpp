// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/texture/texel_store.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <vector>

using namespace trixel;

namespace {

constexpr std::array<std::byte, 3> kGrey{std::byte{128}, std::byte{128}, std::byte{128}};

TexelStore greyStore(std::uint32_t faces, int level = 3)
{
    return TexelStore(faces, TexelFormat{}, Level(level), kGrey);
}

} // namespace

TEST(TexelStore, anUnpaintedStoreHoldsOneValueABlock)
{
    const TexelStore store = greyStore(1000);
    EXPECT_EQ(store.texelCount(), 64'000U);
    EXPECT_EQ(store.storedBytes(), 4U * 3U);
    EXPECT_TRUE(store.face(faceId(999)).isConstant());
}

TEST(TexelStore, writingSpreadsOneFaceAndLeavesItsNeighboursConstant)
{
    TexelStore store = greyStore(300);
    const auto texels = store.writable(faceId(7));
    ASSERT_EQ(texels.size(), 64U * 3U);
    EXPECT_TRUE(std::ranges::all_of(texels, [](std::byte b) { return b == std::byte{128}; }));
    texels[5] = std::byte{1};
    EXPECT_FALSE(store.face(faceId(7)).isConstant());
    EXPECT_EQ(store.face(faceId(7)).bytes()[5], std::byte{1});
    for (std::size_t k : {6U, 8U, 255U, 256U}) {
        EXPECT_TRUE(store.face(faceId(k)).isConstant());
    }
}

TEST(TexelStore, aCopyIsASnapshotThatLaterWritesDoNotReach)
{
    TexelStore store = greyStore(300);
    store.writable(faceId(7))[0] = std::byte{1};
    const TexelStore snapshot = store;
    store.writable(faceId(7))[0] = std::byte{2};
    store.writable(faceId(8))[0] = std::byte{3};
    EXPECT_EQ(snapshot.face(faceId(7)).bytes()[0], std::byte{1});
    EXPECT_TRUE(snapshot.face(faceId(8)).isConstant());
    EXPECT_EQ(store.face(faceId(7)).bytes()[0], std::byte{2});
}

TEST(TexelStore, exchangeReturnsWhatWasThereAndMayChangeTheLevel)
{
    TexelStore store = greyStore(2);
    const std::vector<std::byte> texels(16 * 3, std::byte{9});
    const FaceTexels before = store.exchange(faceId(1), FaceTexels::full(Level(2), 3, texels));
    EXPECT_EQ(before.level(), Level(3));
    EXPECT_EQ(store.face(faceId(1)).level(), Level(2));
    EXPECT_EQ(store.texelCount(), 64U + 16U);
}

TEST(FaceTexels, aFaceOfOneColourCollapsesToOneTexel)
{
    std::vector<std::byte> texels(64 * 3, std::byte{9});
    EXPECT_TRUE(FaceTexels::full(Level(3), 3, texels).collapsed().isConstant());
    texels.back() = std::byte{8};
    EXPECT_FALSE(FaceTexels::full(Level(3), 3, texels).collapsed().isConstant());
}

TEST(FaceTexels, aConstantFaceEqualsTheSameFaceSpreadOut)
{
    const FaceTexels constant = FaceTexels::constant(Level(2), kGrey);
    FaceTexels spread = constant;
    spread.writable();
    EXPECT_EQ(constant, spread);
    EXPECT_TRUE(constant.isConstant());
    spread.writable()[47] = std::byte{0};
    EXPECT_NE(constant, spread);
    EXPECT_NE(constant, FaceTexels::constant(Level(3), kGrey));
}

TEST(FaceTexelsDeathTest, wrongSizesStopTheProgram)
{
    const std::vector<std::byte> texels(5);
    EXPECT_DEATH(FaceTexels::full(Level(2), 3, texels), "broken promise");
    EXPECT_DEATH(greyStore(3).face(faceId(3)), "broken promise");
    EXPECT_DEATH(Level(13), "broken promise");
}
