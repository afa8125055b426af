// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/texture/convert.h"

#include <gtest/gtest.h>

#include <array>
#include <random>
#include <vector>

using namespace trixel;

namespace {

constexpr std::array<std::byte, 3> kGrey{std::byte{51}, std::byte{102}, std::byte{204}};

class StopAtOnce final : public Progress
{
public:
    bool report(double /*fraction*/) override { return false; }
};

TexelStore paintedStore()
{
    TexelStore store(10'000, TexelFormat{}, Level(3), kGrey);
    std::mt19937 random(1);
    for (const std::size_t face : {std::size_t{3}, std::size_t{300}, std::size_t{9999}}) {
        for (std::byte& b : store.writable(faceId(face))) {
            b = std::byte(random() & 255U);
        }
    }
    return store;
}

} // namespace

TEST(Convert, integersSurviveTheWayThroughEveryWiderType)
{
    const TexelStore store = paintedStore();
    for (const TexelType type : {TexelType::UInt16, TexelType::Half, TexelType::Float}) {
        NoProgress progress;
        const auto wide = converted(store, type, Threads{2}, progress);
        ASSERT_TRUE(wide);
        EXPECT_EQ(wide->format().type, type);
        EXPECT_EQ(wide->faceCount(), store.faceCount());
        const auto back = converted(*wide, TexelType::UInt8, Threads{1}, progress);
        ASSERT_TRUE(back);
        for (std::uint32_t k = 0; k < store.faceCount(); ++k) {
            ASSERT_EQ(back->face(faceId(k)), store.face(faceId(k))) << nameOf(type) << " " << k;
            ASSERT_EQ(back->face(faceId(k)).isConstant(), store.face(faceId(k)).isConstant());
        }
    }
}

TEST(Convert, valuesAreThoseOfDecodeAndEncode)
{
    NoProgress progress;
    const auto wide = converted(paintedStore(), TexelType::Float, Threads{2}, progress);
    std::array<float, 3> value{};
    decode(TexelType::Float, wide->face(faceId(0)).bytes(), value);
    EXPECT_EQ(value, (std::array{0.2F, 0.4F, 0.8F}));
}

TEST(Convert, whatWasSharedStaysShared)
{
    const TexelStore store = paintedStore();
    NoProgress progress;
    const auto wide = converted(store, TexelType::UInt16, Threads{2}, progress);
    EXPECT_EQ(wide->storedBytes(), 2 * store.storedBytes());
    EXPECT_TRUE(wide->face(faceId(1000)).sharesBytesWith(wide->face(faceId(5000))));
}

TEST(Convert, levelsStay)
{
    FaceMap<Level> levels(700);
    for (std::size_t k = 0; k < levels.size(); ++k) {
        levels[faceId(k)] = Level(static_cast<int>(k % 5));
    }
    const TexelStore store(TexelFormat{}, levels, kGrey);
    NoProgress progress;
    const auto wide = converted(store, TexelType::Half, Threads{2}, progress);
    for (std::size_t k = 0; k < levels.size(); ++k) {
        ASSERT_EQ(wide->face(faceId(k)).level(), levels[faceId(k)]);
        ASSERT_TRUE(wide->face(faceId(k)).isConstant());
    }
}

TEST(Convert, canBeCancelledAndTheSameTypeIsAPlainCopy)
{
    const TexelStore store = paintedStore();
    StopAtOnce stop;
    const auto stopped = converted(store, TexelType::Half, Threads{1}, stop);
    ASSERT_FALSE(stopped);
    EXPECT_EQ(stopped.error().kind, ErrorKind::Cancelled);
    const auto same = converted(store, TexelType::UInt8, Threads{1}, stop);
    ASSERT_TRUE(same);
    EXPECT_TRUE(same->face(faceId(3)).sharesBytesWith(store.face(faceId(3))));
}
