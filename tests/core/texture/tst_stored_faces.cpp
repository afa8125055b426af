// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/progress.h"
#include "core/texture/stored_faces.h"
#include "core/texture/texel_store.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <set>
#include <thread>

namespace trixel {
namespace {

const TexelFormat kFormat{TexelType::UInt16, 2, std::nullopt};
constexpr std::size_t kTexelBytes = 4;

std::byte byteOf(FaceId face, Level level, std::size_t k)
{
    return static_cast<std::byte>(indexOf(face) * 37 + static_cast<std::size_t>(level.log2()) * 11 +
                                  k * 5 + k / 251);
}

/// Faces of level 5, whose levels 2 and 3 are stored too; those that `fails` cannot be read.
struct Readings
{
    std::atomic<int> base = 0;
    std::atomic<int> coarser = 0;
    bool isSlow = false;
    std::set<std::size_t> fails;
};

constexpr Level kBase(5);

class PatternReader final : public FaceReader
{
public:
    explicit PatternReader(Readings& readings)
        : m_readings(readings)
        , m_mean{std::byte{1}, std::byte{2}, std::byte{3}, std::byte{4}}
    {
    }

    Result<bool> read(FaceId face, Level level, std::span<std::byte> texels) const override
    {
        EXPECT_EQ(texels.size(), level.texelCount() * kTexelBytes);
        ++(level == kBase ? m_readings.base : m_readings.coarser);
        if (m_readings.isSlow) {
            std::this_thread::sleep_for(std::chrono::microseconds(300));
        }
        if (m_readings.fails.contains(indexOf(face))) {
            std::ranges::fill(texels, std::byte{0xEE});
            return contentsError("face " + std::to_string(indexOf(face)) + " is damaged");
        }
        if (level != kBase && !stores(face, level)) {
            return false;
        }
        for (std::size_t k = 0; k < texels.size(); ++k) {
            texels[k] = byteOf(face, level, k);
        }
        return true;
    }
    bool stores(FaceId /*face*/, Level level) const override
    {
        return level == Level(2) || level == Level(3);
    }
    std::span<const std::byte> mean(FaceId /*face*/) const override { return m_mean; }

private:
    Readings& m_readings;
    std::array<std::byte, kTexelBytes> m_mean;
};

constexpr std::size_t kFaceBytes = kBase.texelCount() * kTexelBytes;

class StoredFacesTest : public testing::Test
{
protected:
    explicit StoredFacesTest(std::uint64_t budget = StoredFaces::kDefaultBudget)
        : stored(StoredFaces::make(kFormat, std::make_unique<PatternReader>(readings), budget))
    {
    }

    TexelStore storeOf(std::uint32_t faces)
    {
        TexelStore store(faces, kFormat, kBase, std::vector<std::byte>(kTexelBytes));
        for (std::uint32_t f = 0; f < faces; ++f) {
            store.exchange(faceId(f), stored->face(faceId(f), kBase));
        }
        return store;
    }

    static bool isRead(std::span<const std::byte> texels, FaceId face)
    {
        for (std::size_t k = 0; k < texels.size(); ++k) {
            if (texels[k] != byteOf(face, kBase, k)) {
                return false;
            }
        }
        return texels.size() == kFaceBytes;
    }

    Readings readings;
    std::shared_ptr<StoredFaces> stored;
};

class SmallCacheTest : public StoredFacesTest
{
protected:
    static constexpr std::uint64_t kBudget = 3 * kFaceBytes + 100;
    SmallCacheTest()
        : StoredFacesTest(kBudget)
    {
    }
};

TEST_F(StoredFacesTest, facesAreNotReadBeforeTheirTexelsAreAskedFor)
{
    TexelStore store = storeOf(300);
    const TexelStore copy = store;
    EXPECT_EQ(store.texelCount(), 300U * kBase.texelCount());
    EXPECT_EQ(store.storedBytes(), 300 * kFaceBytes);
    const FaceTexels& face = store.face(faceId(7));
    EXPECT_TRUE(face.isStored());
    EXPECT_FALSE(face.isConstant());
    EXPECT_FALSE(face.isLoaded());
    EXPECT_EQ(face.byteCount(), kFaceBytes);
    EXPECT_EQ(face.mean()->size(), kTexelBytes);
    EXPECT_EQ(face.mean()->front(), std::byte{1});
    EXPECT_TRUE(store.checkWhole());
    EXPECT_EQ(readings.base, 0);
    EXPECT_EQ(readings.coarser, 0);
}

TEST_F(StoredFacesTest, bytesAreReadOnceForAFaceAndItsCopies)
{
    TexelStore store = storeOf(3);
    const TexelStore copy = store;
    const auto bytes = store.face(faceId(1)).bytes();
    EXPECT_TRUE(isRead(bytes, faceId(1)));
    EXPECT_EQ(copy.face(faceId(1)).bytes().data(), bytes.data());
    EXPECT_EQ(store.face(faceId(1)).pinned().bytes().data(), bytes.data());
    EXPECT_TRUE(store.face(faceId(1)).isLoaded());
    EXPECT_EQ(readings.base, 1);
    EXPECT_EQ(stored->heldBytes(), kFaceBytes);
}

TEST_F(StoredFacesTest, manyThreadsThatAskAtOnceReadEachFaceOnce)
{
    constexpr std::uint32_t kFaces = 40;
    readings.isSlow = true; // so that others come meanwhile
    const TexelStore store = storeOf(kFaces);
    std::array<std::array<const std::byte*, kFaces>, 8> seen{};
    std::atomic<int> wrong = 0;
    {
        std::vector<std::jthread> threads;
        for (std::size_t t = 0; t < seen.size(); ++t) {
            threads.emplace_back([&, t] {
                for (std::uint32_t k = 0; k < kFaces; ++k) {
                    const std::uint32_t f = (t % 2 == 0) ? k : kFaces - 1 - k;
                    // Half of them hold the face, the others only look at it.
                    const FaceTexels pinned = store.face(faceId(f)).pinned();
                    const auto bytes = t < 4 ? store.face(faceId(f)).bytes() : pinned.bytes();
                    wrong += isRead(bytes, faceId(f)) ? 0 : 1;
                    seen[t][f] = store.face(faceId(f)).bytes().data();
                }
            });
        }
    }
    EXPECT_EQ(wrong, 0);
    EXPECT_EQ(readings.base, static_cast<int>(kFaces));
    for (const auto& other : seen) {
        EXPECT_EQ(other, seen.front());
    }
}

TEST_F(SmallCacheTest, pinnedFacesStayWithinTheBudget)
{
    const TexelStore store = storeOf(20);
    std::uint64_t most = 0;
    for (int round = 0; round < 2; ++round) {
        for (std::uint32_t f = 0; f < 20; ++f) {
            EXPECT_TRUE(isRead(store.face(faceId(f)).pinned().bytes(), faceId(f)));
            most = std::max(most, stored->cachedBytes());
        }
    }
    EXPECT_EQ(most, 3 * kFaceBytes);
    EXPECT_EQ(stored->heldBytes(), 0U);
    EXPECT_EQ(readings.base, 40);
    // What was read last is still there, the oldest is not.
    EXPECT_TRUE(isRead(store.face(faceId(18)).pinned().bytes(), faceId(18)));
    EXPECT_EQ(readings.base, 40);
    EXPECT_TRUE(isRead(store.face(faceId(2)).pinned().bytes(), faceId(2)));
    EXPECT_EQ(readings.base, 41);
}

TEST_F(SmallCacheTest, pinnedTexelsOutliveTheCache)
{
    const TexelStore store = storeOf(20);
    const FaceTexels first = store.face(faceId(0)).pinned();
    for (std::uint32_t f = 1; f < 20; ++f) {
        EXPECT_EQ(store.face(faceId(f)).pinned().level(), kBase);
    }
    EXPECT_TRUE(isRead(first.bytes(), faceId(0)));
}

TEST_F(SmallCacheTest, aFaceLargerThanTheBudgetIsReadButNotKept)
{
    const auto tiny = StoredFaces::make(kFormat, std::make_unique<PatternReader>(readings), 100);
    EXPECT_TRUE(isRead(tiny->face(faceId(3), kBase).pinned().bytes(), faceId(3)));
    EXPECT_EQ(tiny->cachedBytes(), 0U);
}

TEST_F(StoredFacesTest, releasedTexelsAreFreedWhenNoCopyHoldsThem)
{
    TexelStore store = storeOf(600);
    for (const std::uint32_t f : {5U, 300U, 599U}) {
        EXPECT_TRUE(isRead(store.face(faceId(f)).bytes(), faceId(f)));
    }
    EXPECT_EQ(stored->heldBytes(), 3 * kFaceBytes);
    {
        const TexelStore snapshot = store;
        const auto bytes = snapshot.face(faceId(300)).bytes();
        store.releaseHeld();
        EXPECT_FALSE(store.face(faceId(300)).isLoaded());
        EXPECT_TRUE(isRead(bytes, faceId(300)));
        EXPECT_EQ(stored->heldBytes(), 3 * kFaceBytes);
    }
    EXPECT_EQ(stored->heldBytes(), 0U);
    EXPECT_TRUE(isRead(store.face(faceId(300)).bytes(), faceId(300)));
}

TEST_F(SmallCacheTest, paintedFacesAreNeverDropped)
{
    TexelStore store = storeOf(20);
    const TexelStore before = store;
    store.writable(faceId(4))[9] ^= std::byte{0xFF};
    EXPECT_FALSE(store.face(faceId(4)).isStored());
    store.releaseHeld();
    for (std::uint32_t f = 0; f < 20; ++f) {
        EXPECT_EQ(store.face(faceId(f)).pinned().byteCount(), kFaceBytes);
    }
    const auto bytes = store.face(faceId(4)).bytes();
    EXPECT_EQ(bytes[9], byteOf(faceId(4), kBase, 9) ^ std::byte{0xFF});
    EXPECT_EQ(bytes[10], byteOf(faceId(4), kBase, 10));
    EXPECT_TRUE(isRead(before.face(faceId(4)).bytes(), faceId(4)));
    EXPECT_NE(store.face(faceId(4)), before.face(faceId(4)));
    EXPECT_EQ(store.face(faceId(5)), before.face(faceId(5)));
}

TEST_F(StoredFacesTest, coarserLevelsComeFromTheFileWithoutTheBase)
{
    const FaceTexels face = stored->face(faceId(9), kBase);
    EXPECT_TRUE(face.hasStoredLevel(Level(3)));
    EXPECT_FALSE(face.hasStoredLevel(Level(4)));
    const auto coarse = face.storedLevel(Level(3));
    ASSERT_TRUE(coarse);
    EXPECT_EQ(coarse->level(), Level(3));
    EXPECT_EQ(coarse->bytes()[17], byteOf(faceId(9), Level(3), 17));
    EXPECT_FALSE(face.storedLevel(Level(4)));
    EXPECT_EQ(readings.base, 0);
    EXPECT_EQ(readings.coarser, 1);
    // Neither is there anything to be had of texels in memory, but of constant ones.
    EXPECT_FALSE(face.pinned().storedLevel(Level(3)));
    EXPECT_FALSE(face.pinned().mean());
    const FaceTexels constant = FaceTexels::constant(kBase, *face.mean());
    EXPECT_EQ(constant.storedLevel(Level(3)), constant.atLevel(Level(3)));
}

TEST_F(StoredFacesTest, aFaceThatCannotBeReadIsNotedOnceAndShownAsChecks)
{
    readings.fails = {2};
    TexelStore store = storeOf(4);
    EXPECT_FALSE(store.face(faceId(2)).isDamaged());
    const auto bytes = store.face(faceId(2)).bytes();
    EXPECT_EQ(bytes.size(), kFaceBytes);
    EXPECT_EQ(std::ranges::count(bytes, std::byte{0xEE}), 0); // nothing of the failed read
    EXPECT_FALSE(store.face(faceId(2)).collapsed().isConstant());
    store.releaseHeld();
    EXPECT_TRUE(std::ranges::equal(store.face(faceId(2)).pinned().bytes(),
                                   storeOf(4).face(faceId(2)).bytes()));
    EXPECT_EQ(readings.base, 1);
    EXPECT_EQ(stored->faults(), (std::vector<FaceFault>{{faceId(2), "face 2 is damaged"}}));
    EXPECT_TRUE(stored->faults(1).empty());
    EXPECT_TRUE(store.face(faceId(2)).isDamaged());
    EXPECT_FALSE(store.face(faceId(1)).isDamaged());
    ASSERT_FALSE(store.checkWhole());
    EXPECT_NE(store.checkWhole().error().message.find("face 2 "), std::string::npos);
}

TEST_F(StoredFacesTest, damageStaysWithWhatIsPaintedOverAndLeavesWithAFill)
{
    readings.fails = {2};
    TexelStore store = storeOf(4);
    store.writable(faceId(2))[0] = std::byte{1};
    EXPECT_FALSE(store.face(faceId(2)).isStored());
    EXPECT_TRUE(store.face(faceId(2)).isDamaged());
    EXPECT_FALSE(store.checkWhole());
    std::ranges::fill(store.writable(faceId(2)), std::byte{1});
    EXPECT_TRUE(store.face(faceId(2)).collapsed().isDamaged());
    const std::vector<std::byte> color(kTexelBytes, std::byte{7});
    const FaceTexels before = store.exchange(faceId(2), FaceTexels::constant(kBase, color));
    EXPECT_TRUE(store.checkWhole());
    store.exchange(faceId(2), before); // undone
    EXPECT_FALSE(store.checkWhole());
}

TEST_F(SmallCacheTest, convertingAStoreReadsWithinTheBudgetAndRefusesDamage)
{
    const TexelStore store = storeOf(20);
    const auto same = [](const FaceTexels& face) { return face; };
    NoProgress silent;
    const auto whole = store.transformed(kFormat, same, Threads{2}, silent);
    ASSERT_TRUE(whole);
    EXPECT_EQ(whole->face(faceId(11)), store.face(faceId(11)));
    EXPECT_EQ(stored->heldBytes(), 0U);
    readings.fails = {13};
    const TexelStore damaged = storeOf(20);
    EXPECT_FALSE(damaged.transformed(kFormat, same, Threads{2}, silent));
}

} // namespace
} // namespace trixel
