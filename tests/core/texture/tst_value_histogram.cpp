// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/texture/value_histogram.h"
#include "tests/core/cancel_after.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <gmock/gmock.h>
#include <limits>
#include <map>
#include <numeric>
#include <random>

namespace trixel {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();
const float kNan = std::nanf("");
constexpr std::array<float, 3> kMean{0.25F, 0.5F, 0.25F};

std::vector<std::byte> stored(TexelType type, std::span<const float> values)
{
    std::vector<std::byte> bytes(values.size() * byteSize(type));
    encode(type, values, bytes);
    return bytes;
}

TexelStore storeOf(const TexelFormat& format, std::vector<FaceTexels> faces)
{
    const std::vector<std::byte> fill(format.texelBytes());
    TexelStore store(static_cast<std::uint32_t>(faces.size()), format, Level(0), fill);
    for (std::size_t f = 0; f < faces.size(); ++f) {
        store.exchange(faceId(f), std::move(faces[f]));
    }
    return store;
}

FaceTexels face(const TexelFormat& format, int level, std::span<const float> values)
{
    return FaceTexels::full(Level(level), format.texelBytes(), stored(format.type, values));
}

std::vector<ValueHistogram>
counted(const TexelStore& store, std::vector<TexelNumber> numbers, unsigned threads = 1)
{
    NoProgress progress;
    return countValues(store, numbers, Threads{threads}, progress).value();
}

ValueHistogram channel(const TexelStore& store, std::uint16_t c)
{
    return counted(store, {{c, {}}}).front();
}

std::uint64_t sumOf(const ValueHistogram& histogram)
{
    std::uint64_t sum = 0;
    for (const auto& bucket : histogram.buckets()) {
        sum += bucket.count;
    }
    return sum;
}

TEST(ValueHistogram, countsEachByteOfEachChannel)
{
    const TexelFormat format;
    std::vector<float> values;
    for (int k = 0; k < 4; ++k) {
        values.insert(values.end(), {0.0F, static_cast<float>(k) / 255, 1.0F});
    }
    const TexelStore store = storeOf(format, {face(format, 1, values)});
    const auto histograms = counted(store, {{0, {}}, {1, {}}, {2, {}}});
    ASSERT_EQ(histograms.size(), 3U);
    ASSERT_EQ(histograms[0].buckets().size(), 1U);
    EXPECT_EQ(histograms[0].buckets()[0].value, 0);
    EXPECT_EQ(histograms[0].buckets()[0].count, 4U);
    ASSERT_EQ(histograms[1].buckets().size(), 4U);
    EXPECT_EQ(histograms[1].buckets()[3].value, 3.0F / 255);
    EXPECT_EQ(histograms[1].buckets()[3].count, 1U);
    EXPECT_EQ(histograms[2].summary().least, 1);
    EXPECT_TRUE(histograms[2].isExact());
}

TEST(ValueHistogram, aConstantFaceCountsForAllItsTexels)
{
    for (const TexelType type :
         {TexelType::UInt8, TexelType::UInt16, TexelType::Half, TexelType::Float}) {
        const TexelFormat format{type, 3, {}};
        const std::vector<float> one{1, 0, 1};
        const FaceTexels constant = FaceTexels::constant(Level(5), stored(type, one));
        const std::vector<float> zeros(12);
        const TexelStore store = storeOf(format, {constant, face(format, 1, zeros), constant});
        const auto histograms = counted(store, {{0, {}}, {0, kMean}});
        for (const ValueHistogram& histogram : histograms) {
            EXPECT_EQ(histogram.summary().total, 2052U);
            ASSERT_EQ(histogram.buckets().size(), 2U);
            EXPECT_EQ(histogram.buckets()[0].count, 4U);
            EXPECT_EQ(histogram.buckets()[1].count, 2048U);
        }
        EXPECT_EQ(histograms[0].summary().greatest, 1);
        EXPECT_EQ(histograms[1].summary().greatest, 0.5F);
    }
}

TEST(ValueHistogram, whatIsNoFiniteNumberIsCountedApart)
{
    const std::vector<float> values{kNan,
                                    -kNan,
                                    kInfinity,
                                    -kInfinity,
                                    -0.0F,
                                    0.0F,
                                    -1e-7F,
                                    -5,
                                    0.5F,
                                    60000,
                                    0.25F,
                                    kNan,
                                    -2,
                                    -3,
                                    -4,
                                    -5};
    for (const TexelType type : {TexelType::Half, TexelType::Float}) {
        const TexelFormat format{type, 1, {}};
        const ValueHistogram histogram = channel(storeOf(format, {face(format, 2, values)}), 0);
        const ValueHistogram::Summary& summary = histogram.summary();
        EXPECT_EQ(summary.total, 16U);
        EXPECT_EQ(summary.notANumber, 3U);
        EXPECT_EQ(summary.infinite, 2U);
        EXPECT_EQ(summary.negative, 6U); // not -0
        EXPECT_EQ(summary.least, -5);
        EXPECT_EQ(summary.greatest, 60000);
        EXPECT_EQ(summary.finite(), 11U);
        EXPECT_EQ(sumOf(histogram), 11U);
    }
}

TEST(ValueHistogram, aNanOfAnyBitsIsNone)
{
    // The upper half of these is that of an infinite number.
    const std::vector<std::uint32_t> bits{0x7f800001U, 0xff800001U, 0x7f80ffffU, 0x7f800000U};
    const TexelFormat format{TexelType::Float, 1, {}};
    const TexelStore store =
        storeOf(format, {FaceTexels::full(Level(1), 4, std::as_bytes(std::span(bits)))});
    EXPECT_EQ(channel(store, 0).summary().notANumber, 3U);
    EXPECT_EQ(channel(store, 0).summary().infinite, 1U);
}

TEST(ValueHistogram, bucketsAreInOrderAndHoldTheirValues)
{
    std::mt19937 random(3);
    std::normal_distribution<float> in(0, 2);
    std::vector<float> values(4096);
    std::ranges::generate(values, [&] { return in(random); });
    for (const TexelType type :
         {TexelType::UInt8, TexelType::UInt16, TexelType::Half, TexelType::Float}) {
        const TexelFormat format{type, 1, {}};
        const TexelStore store = storeOf(format, {face(format, 6, values)});
        const ValueHistogram histogram = channel(store, 0);
        EXPECT_EQ(sumOf(histogram), 4096U);
        float before = -kInfinity;
        for (const auto& bucket : histogram.buckets()) {
            EXPECT_LT(bucket.from, bucket.to);
            EXPECT_LE(before, bucket.from);
            EXPECT_LE(bucket.from, bucket.value);
            EXPECT_LE(bucket.value, bucket.to);
            // Neighbours of integers meet at a half, up to rounding.
            before = std::nextafter(bucket.to, -kInfinity);
        }
    }
}

/// Every value as the store gives it back, sorted.
std::vector<float> sorted(TexelType type, std::span<const float> values)
{
    std::vector<float> back(values.size());
    decode(type, stored(type, values), back);
    std::ranges::sort(back);
    return back;
}

TEST(ValueHistogram, aboveAndQuantilesAreThoseOfTheSortedValues)
{
    std::mt19937 random(5);
    std::uniform_real_distribution<float> in(-0.2F, 1.3F);
    std::vector<float> values(4096);
    std::ranges::generate(values, [&] { return in(random); });
    for (const TexelType type :
         {TexelType::UInt8, TexelType::UInt16, TexelType::Half, TexelType::Float}) {
        const TexelFormat format{type, 1, {}};
        const ValueHistogram histogram = channel(storeOf(format, {face(format, 6, values)}), 0);
        const std::vector<float> all = sorted(type, values);
        const bool isExact = type != TexelType::Float;
        EXPECT_EQ(histogram.isExact(), isExact);
        for (const float value : {-1.0F, -0.1F, 0.0F, 0.3F, 0.7F, 1.0F, 2.0F}) {
            const auto above =
                static_cast<double>(all.end() - std::ranges::upper_bound(all, value));
            EXPECT_NEAR(static_cast<double>(histogram.above(value)), above, isExact ? 0 : 20)
                << value;
        }
        for (const double share : {0.0, 0.001, 0.25, 0.5, 0.999, 1.0}) {
            const auto place = static_cast<std::size_t>(std::max(0.0, std::ceil(share * 4096) - 1));
            EXPECT_NEAR(histogram.quantile(share).value(), all[place], isExact ? 0 : 0.008)
                << share;
        }
        EXPECT_EQ(histogram.quantile(0), all.front());
        EXPECT_EQ(histogram.quantile(1), all.back());
        EXPECT_EQ(histogram.above(kNan), 0U);
        EXPECT_EQ(histogram.above(all.back()), 0U);
    }
}

TEST(ValueHistogram, floatsAboveRoundNumbersAreCountedExactly)
{
    const TexelFormat format{TexelType::Float, 1, {}};
    const std::vector<float> values{1,
                                    1,
                                    std::nextafter(1.0F, 2.0F),
                                    1.004F,
                                    0.75F,
                                    0.752F,
                                    -1,
                                    -1,
                                    0,
                                    0,
                                    -0.0F,
                                    1e-41F,
                                    -1.5F,
                                    -1.499F,
                                    2,
                                    3};
    const ValueHistogram histogram = channel(storeOf(format, {face(format, 2, values)}), 0);
    for (const float value : {-2.0F, -1.5F, -1.0F, -0.5F, 0.0F, 0.75F, 1.0F, 1.5F, 2.0F, 3.0F}) {
        const auto above =
            std::ranges::count_if(values, [&](float other) { return other > value; });
        EXPECT_TRUE(histogram.isExactAbove(value));
        EXPECT_EQ(histogram.above(value), static_cast<std::uint64_t>(above)) << value;
    }
    EXPECT_FALSE(histogram.isExactAbove(1.001F));
    EXPECT_EQ(histogram.quantile(0.45), 0.0F); // not the least number above it
}

TEST(ValueHistogram, partsHoldWhatLiesInTheRange)
{
    const TexelFormat format{TexelType::UInt8, 1, {}};
    const std::vector<float> values{0, 0.2F, 0.2F, 1};
    const ValueHistogram histogram = channel(storeOf(format, {face(format, 1, values)}), 0);
    EXPECT_THAT(histogram.parts(-0.5F, 1.5F, 4),
                testing::Pointwise(testing::DoubleNear(1e-4), {0.5, 2.5, 0.5, 0.5}));
    const std::vector<double> fine = histogram.parts(0.1F, 0.3F, 1000);
    EXPECT_NEAR(std::accumulate(fine.begin(), fine.end(), 0.0), 2, 1e-3);
    EXPECT_EQ(fine.front(), 0);
    const std::vector<double> outside = histogram.parts(2, 3, 5);
    EXPECT_EQ(std::accumulate(outside.begin(), outside.end(), 0.0), 0);
}

TEST(ValueHistogram, partsOfManyFloatsAddUp)
{
    std::mt19937 random(6);
    std::normal_distribution<float> in(0.3F, 0.1F);
    std::vector<float> values(4096);
    std::ranges::generate(values, [&] { return in(random); });
    const TexelFormat format{TexelType::Float, 1, {}};
    const ValueHistogram histogram = channel(storeOf(format, {face(format, 6, values)}), 0);
    for (const std::size_t count : {1U, 7U, 300U}) {
        const std::vector<double> parts = histogram.parts(-1, 2, count);
        EXPECT_NEAR(std::accumulate(parts.begin(), parts.end(), 0.0), 4096, 1e-3);
    }
}

TEST(ValueHistogram, ofNoFacesHasNoValues)
{
    const ValueHistogram histogram =
        channel(TexelStore(0, TexelFormat{}, Level(0), std::vector<std::byte>(3)), 0);
    EXPECT_EQ(histogram.summary(), ValueHistogram::Summary());
    EXPECT_EQ(histogram.quantile(0.5), std::nullopt);
    EXPECT_EQ(histogram.above(-1), 0U);
}

TexelStore largeAndSmallFaces()
{
    const TexelFormat format{TexelType::UInt16, 3, {}};
    std::mt19937 random(9);
    std::uniform_real_distribution<float> in(0, 1);
    std::vector<FaceTexels> faces;
    for (const int level : {9, 0, 1, 3, 10, 2, 5}) {
        std::vector<float> values(Level(level).texelCount() * 3);
        std::ranges::generate(values, [&] { return in(random); });
        faces.push_back(face(format, level, values));
        faces.push_back(FaceTexels::constant(Level(level), faces.back().texel(0)));
    }
    return storeOf(format, std::move(faces));
}

TEST(ValueHistogram, threadsAndPiecesDoNotMatter)
{
    const TexelStore store = largeAndSmallFaces();
    std::map<float, std::uint64_t> byHand;
    std::vector<float> values(3);
    for (std::size_t f = 0; f < store.faceCount(); ++f) {
        const FaceTexels& texels = store.face(faceId(f));
        for (std::size_t t = 0; t < texels.level().texelCount(); ++t) {
            decode(TexelType::UInt16, texels.texel(t), values);
            ++byHand[values[1]];
        }
    }
    for (const unsigned threads : {1U, 2U, 5U}) {
        const auto histograms = counted(store, {{1, {}}, {0, kMean}}, threads);
        ASSERT_EQ(histograms[0].buckets().size(), byHand.size());
        auto wanted = byHand.begin();
        for (const auto& bucket : histograms[0].buckets()) {
            ASSERT_EQ(bucket.value, wanted->first);
            ASSERT_EQ(bucket.count, wanted->second);
            ++wanted;
        }
        EXPECT_EQ(sumOf(histograms[1]), store.texelCount());
    }
}

TEST(ValueHistogram, countingCanBeCancelled)
{
    const TexelStore store = largeAndSmallFaces();
    for (const int call : {0, 1, 4}) {
        CancelAfter progress(call);
        const auto result =
            countValues(store, std::array{TexelNumber{0, {}}}, Threads{2}, progress);
        ASSERT_FALSE(result);
        EXPECT_EQ(result.error().kind, ErrorKind::Cancelled);
    }
}

} // namespace
} // namespace trixel
