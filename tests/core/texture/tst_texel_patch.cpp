// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/texture/texel_patch.h"

#include <gtest/gtest.h>

#include <array>
#include <random>
#include <vector>

using namespace trixel;

namespace {

constexpr std::array<std::byte, 3> kGrey{std::byte{128}, std::byte{128}, std::byte{128}};
constexpr std::array<std::byte, 3> kRed{std::byte{255}, std::byte{0}, std::byte{0}};

std::vector<FaceTexels> facesOf(const TexelStore& store)
{
    std::vector<FaceTexels> faces;
    for (std::uint32_t k = 0; k < store.faceCount(); ++k) {
        faces.push_back(store.face(faceId(k)));
    }
    return faces;
}

bool sameToTheBit(const std::vector<FaceTexels>& a, const std::vector<FaceTexels>& b)
{
    return std::ranges::equal(a, b, [](const FaceTexels& x, const FaceTexels& y) {
        return x.isConstant() == y.isConstant() && x.level() == y.level() &&
               std::ranges::equal(x.bytes(), y.bytes());
    });
}

} // namespace

TEST(TexelPatch, swappingTwiceChangesNothingOverRandomPrograms)
{
    std::mt19937 random(1);
    TexelStore store(600, TexelFormat{}, Level(3), kGrey);
    std::vector<TexelPatch> patches;
    std::vector<std::vector<FaceTexels>> states{facesOf(store)};
    for (int step = 0; step < 60; ++step) {
        TexelPatch patch;
        for (std::size_t face = random() % 20; face < 600; face += 1 + random() % 40) {
            const FaceTexels before = store.face(faceId(face));
            if (before.isConstant() || random() % 4 == 0) {
                patch.addFace(faceId(face), before);
                if (random() % 2 == 0) {
                    store.exchange(
                        faceId(face),
                        FaceTexels::constant(Level(static_cast<int>(random() % 5)), kRed));
                } else {
                    store.writable(faceId(face))[0] = std::byte(random() & 255U);
                }
                continue;
            }
            const std::uint32_t texels = before.level().texelCount();
            const TexelPatch::Run first{0, 1};
            const TexelPatch::Run second{texels / 2 + 1, texels > 4 ? 3U : 0U};
            std::vector<TexelPatch::Run> runs{first};
            if (second.count > 0) {
                runs.push_back(second);
            }
            std::vector<std::byte> values;
            const auto writable = store.writable(faceId(face));
            for (const auto& run : runs) {
                for (std::size_t b = run.first * 3U; b < (run.first + run.count) * 3U; ++b) {
                    values.push_back(writable[b]);
                    writable[b] = std::byte(random() & 255U);
                }
            }
            patch.addTexels(faceId(face), runs, values);
        }
        patches.push_back(std::move(patch));
        states.push_back(facesOf(store));
    }
    for (std::size_t k = patches.size(); k-- > 0;) {
        patches[k].swap(store);
        ASSERT_TRUE(sameToTheBit(facesOf(store), states[k])) << "undo of step " << k;
    }
    for (std::size_t k = 0; k < patches.size(); ++k) {
        patches[k].swap(store);
        ASSERT_TRUE(sameToTheBit(facesOf(store), states[k + 1])) << "redo of step " << k;
    }
}

TEST(TexelPatch, facesLeftOfOneColourStoreOneValueAndComeBackOnUndo)
{
    TexelStore store(3, TexelFormat{}, Level(2), kGrey);
    store.writable(faceId(0))[0] = std::byte{7}; // two colours
    store.writable(faceId(1))[0] = std::byte{7};
    store.writable(faceId(2)); // one colour, spread out
    const std::vector<FaceTexels> before = facesOf(store);

    TexelPatch patch;
    const TexelPatch::Run firstTexel{0, 1};
    for (std::size_t k = 0; k < 2; ++k) {
        patch.addTexels(faceId(k), std::span(&firstTexel, 1), store.face(faceId(k)).texel(0));
        std::ranges::copy(kRed, store.writable(faceId(k)).begin());
    }
    std::ranges::copy(kGrey, store.writable(faceId(1)).begin()); // face 1 is all grey now
    patch.addFace(faceId(2), store.face(faceId(2)));
    patch.collapseFaces(store);

    EXPECT_FALSE(store.face(faceId(0)).isConstant());
    EXPECT_TRUE(store.face(faceId(1)).isConstant());
    EXPECT_TRUE(store.face(faceId(2)).isConstant());
    const std::vector<FaceTexels> after = facesOf(store);
    patch.swap(store);
    EXPECT_TRUE(sameToTheBit(facesOf(store), before));
    patch.swap(store);
    EXPECT_TRUE(sameToTheBit(facesOf(store), after));
    EXPECT_EQ(patch.faces().size(), 3U);
}

TEST(TexelPatch, snapshotsOfTheStoreAreNotTouchedBySwaps)
{
    TexelStore store(3, TexelFormat{}, Level(2), kGrey);
    store.writable(faceId(1))[5] = std::byte{9};
    const TexelStore snapshot = store;
    TexelPatch patch;
    const std::array runs{TexelPatch::Run{1, 1}};
    patch.addTexels(faceId(1), runs, kRed);
    patch.swap(store);
    EXPECT_EQ(store.face(faceId(1)).bytes()[3], std::byte{255});
    EXPECT_EQ(snapshot.face(faceId(1)).bytes()[3], std::byte{128});
}

TEST(TexelPatch, namesItsFacesOnceInOrderAndCountsItsBytes)
{
    TexelPatch patch;
    EXPECT_TRUE(patch.isEmpty());
    const std::array runs{TexelPatch::Run{0, 1}};
    patch.addTexels(faceId(7), runs, kRed);
    patch.addFace(faceId(2), FaceTexels::constant(Level(12), kRed));
    EXPECT_EQ(std::vector(patch.faces().begin(), patch.faces().end()),
              (std::vector{faceId(7), faceId(2)}));
    EXPECT_GT(patch.byteSize(), 6U);
    EXPECT_LT(patch.byteSize(), 300U); // a constant face costs one texel, not 4^12
}

TEST(TexelPatchDeathTest, refusesRunsThatTouchOrLieOutside)
{
    TexelPatch patch;
    const std::array touching{TexelPatch::Run{0, 1}, TexelPatch::Run{1, 1}};
    const std::array<std::byte, 6> two{};
    EXPECT_DEATH(patch.addTexels(faceId(0), touching, two), "runs apart");
    const std::array outside{TexelPatch::Run{16, 1}};
    patch.addTexels(faceId(0), outside, kRed);
    TexelStore store(1, TexelFormat{}, Level(2), kGrey);
    EXPECT_DEATH(patch.swap(store), "inside the face");
}
