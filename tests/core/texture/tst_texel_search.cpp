// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/texture/texel_search.h"

#include <gtest/gtest.h>

#include <array>
#include <vector>

namespace trixel {
namespace {

const TexelFormat kFormat{TexelType::UInt8, 2, {}};

/// The first texel whose second channel is full.
std::optional<std::size_t> isFull(std::span<const float> values)
{
    for (std::size_t k = 0; k < values.size() / 2; ++k) {
        if (values[2 * k + 1] == 1.0F) {
            return k;
        }
    }
    return std::nullopt;
}

TexelStore emptyStore()
{
    TexelStore store(600, kFormat, Level(1), std::vector<std::byte>(2));
    const std::vector<std::byte> many(Level(7).texelCount() * 2);
    store.exchange(FaceId{300}, FaceTexels::full(Level(7), 2, many));
    (void)store.writable(FaceId{5});
    return store;
}

void fill(TexelStore& store, std::uint32_t face, std::size_t index)
{
    store.writable(FaceId{face})[2 * index + 1] = std::byte{255};
}

std::optional<TexelSpot> next(const TexelStore& store, std::optional<TexelSpot> after = {})
{
    NoProgress progress;
    return nextTexel(store, after, isFull, progress).value();
}

TexelSpot spot(std::uint32_t face, std::uint32_t index)
{
    return {FaceId{face}, static_cast<TexelIndex>(index)};
}

TEST(NextTexel, goesRoundThroughAllThatAreLookedFor)
{
    TexelStore store = emptyStore();
    fill(store, 5, 1);
    fill(store, 5, 3);
    fill(store, 300, 9000); // beyond the first batch
    fill(store, 300, 16383);
    store.exchange(FaceId{599},
                   FaceTexels::constant(Level(4), std::array{std::byte{0}, std::byte{255}}));
    const std::array<TexelSpot, 5> wanted{
        spot(5, 1), spot(5, 3), spot(300, 9000), spot(300, 16383), spot(599, 0)};
    std::optional<TexelSpot> at;
    for (int k = 0; k < 12; ++k) {
        at = next(store, at);
        ASSERT_EQ(at, wanted[static_cast<std::size_t>(k) % wanted.size()]) << k;
    }
}

TEST(NextTexel, findsTheOneThatItComesFromWhenItIsAlone)
{
    TexelStore store = emptyStore();
    fill(store, 5, 2);
    EXPECT_EQ(next(store, spot(5, 2)), spot(5, 2));
    EXPECT_EQ(next(store, spot(5, 1)), spot(5, 2));
    EXPECT_EQ(next(store, spot(5, 3)), spot(5, 2));
}

TEST(NextTexel, aConstantFaceIsOneTexelWhereverItIsBegunFrom)
{
    TexelStore store = emptyStore();
    store.exchange(FaceId{7},
                   FaceTexels::constant(Level(4), std::array{std::byte{0}, std::byte{255}}));
    EXPECT_EQ(next(store, spot(7, 200)), spot(7, 0));
    fill(store, 9, 0);
    EXPECT_EQ(next(store, spot(7, 200)), spot(9, 0));
}

TEST(NextTexel, findsNothingWhereThereIsNothing)
{
    EXPECT_EQ(next(emptyStore()), std::nullopt);
    EXPECT_EQ(next(emptyStore(), spot(300, 5)), std::nullopt);
    EXPECT_EQ(next(TexelStore()), std::nullopt);
}

TEST(NextTexel, canBeCancelled)
{
    class Never final : public Progress
    {
    public:
        bool report(double /*fraction*/) override { return false; }
    };
    Never progress;
    const auto result = nextTexel(emptyStore(), std::nullopt, isFull, progress);
    ASSERT_FALSE(result);
    EXPECT_EQ(result.error().kind, ErrorKind::Cancelled);
}

} // namespace
} // namespace trixel
