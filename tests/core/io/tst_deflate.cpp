// SPDX-License-Identifier: GPL-3.0-or-later
//
// What is zipped, zlib unzips to the same bytes.
#include <queue>

#include "core/io/deflate.h"
#include "core/io/huffman.h"
#include "core/io/inflate.h"
#include "core/io/small_deflate.h"
#include "core/io/small_inflate.h"
#include "tests/core/io/inflate_oracle.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <random>
#include <vector>
#include <zlib.h>

using namespace trixel;

namespace {

using Bytes = std::vector<std::byte>;

Bytes generated(std::size_t size, const std::function<unsigned(std::size_t)>& value)
{
    Bytes bytes(size);
    for (std::size_t k = 0; k < size; ++k) {
        bytes[k] = static_cast<std::byte>(value(k));
    }
    return bytes;
}

Bytes unzippedByZlib(std::span<const std::byte> stream, std::size_t size)
{
    Bytes bytes(size + 1); // one more, to see a stream that gives too much
    uLongf found = bytes.size();
    const int status = uncompress(reinterpret_cast<Bytef*>(bytes.data()),
                                  &found,
                                  reinterpret_cast<const Bytef*>(stream.data()),
                                  stream.size());
    EXPECT_EQ(status, Z_OK);
    bytes.resize(found);
    return bytes;
}

class Zipper
{
public:
    std::span<const std::byte> zip(const Bytes& bytes)
    {
        m_out.assign(SmallDeflater::roomFor(bytes.size()) + kGuard, std::byte{0xA5});
        const std::size_t size =
            m_deflater.zip(bytes, std::span(m_out).first(SmallDeflater::roomFor(bytes.size())));
        EXPECT_LE(size, SmallDeflater::roomFor(bytes.size()));
        EXPECT_TRUE(std::all_of(
            m_out.end() - kGuard, m_out.end(), [](std::byte b) { return b == std::byte{0xA5}; }));
        return std::span(m_out).first(size);
    }
    void expectRoundTrip(const Bytes& bytes)
    {
        const auto stream = zip(bytes);
        ASSERT_EQ(unzippedByZlib(stream, bytes.size()), bytes);
        Bytes back(bytes.size());
        ASSERT_TRUE(m_inflater.unzip(stream, back));
        ASSERT_EQ(back, bytes);
    }

private:
    static constexpr std::ptrdiff_t kGuard = 16;
    SmallDeflater m_deflater;
    Inflater m_inflater;
    Bytes m_out;
};

// By any level and strategy, in one block or several.
std::vector<std::byte> zippedByZlib(const Bytes& bytes, std::mt19937& random)
{
    constexpr int kStrategies[] = {Z_DEFAULT_STRATEGY, Z_HUFFMAN_ONLY, Z_RLE, Z_FIXED};
    z_stream stream{};
    deflateInit2(&stream,
                 static_cast<int>(random() % 10),
                 Z_DEFLATED,
                 9 + static_cast<int>(random() % 7),
                 1 + static_cast<int>(random() % 9),
                 kStrategies[random() % 4]);
    std::vector<std::byte> out(bytes.size() * 2 + 1000);
    stream.next_out = reinterpret_cast<Bytef*>(out.data());
    stream.avail_out = static_cast<uInt>(out.size());
    stream.next_in = reinterpret_cast<Bytef*>(const_cast<std::byte*>(bytes.data()));
    if (random() % 3 == 0) {
        stream.avail_in = static_cast<uInt>(bytes.size() / 2);
        deflate(&stream, random() % 2 == 0 ? Z_FULL_FLUSH : Z_PARTIAL_FLUSH);
        stream.avail_in = static_cast<uInt>(bytes.size() - bytes.size() / 2);
    } else {
        stream.avail_in = static_cast<uInt>(bytes.size());
    }
    EXPECT_EQ(deflate(&stream, Z_FINISH), Z_STREAM_END);
    out.resize(stream.total_out);
    deflateEnd(&stream);
    return out;
}

// Cost of an optimal code: the sum of all joined weights.
std::uint64_t optimalCost(std::span<const std::uint16_t> counts)
{
    std::priority_queue<std::uint64_t, std::vector<std::uint64_t>, std::greater<>> heap;
    for (const std::uint16_t count : counts) {
        if (count > 0) {
            heap.push(count);
        }
    }
    std::uint64_t cost = 0;
    while (heap.size() > 1) {
        std::uint64_t sum = heap.top();
        heap.pop();
        sum += heap.top();
        heap.pop();
        cost += sum;
        heap.push(sum);
    }
    return cost;
}

} // namespace

TEST(Huffman, lengthsAreOptimalAndFillTheCode)
{
    std::mt19937 random(3);
    for (int round = 0; round < 2000; ++round) {
        std::vector<std::uint16_t> counts(2 + random() % 280);
        const unsigned spread = 1U << (random() % 8);
        for (std::uint16_t& count : counts) {
            count = static_cast<std::uint16_t>(random() % 3 == 0 ? random() % spread : 0);
        }
        counts[0] = 1;
        counts[1] = 2;
        std::vector<std::uint8_t> lengths(counts.size());
        huffmanLengths(counts, 15, lengths);
        std::uint64_t cost = 0;
        double kraft = 0;
        for (std::size_t k = 0; k < counts.size(); ++k) {
            ASSERT_EQ(lengths[k] > 0, counts[k] > 0);
            cost += std::uint64_t{counts[k]} * lengths[k];
            kraft += lengths[k] > 0 ? std::ldexp(1.0, -lengths[k]) : 0;
        }
        ASSERT_EQ(cost, optimalCost(counts));
        ASSERT_EQ(kraft, 1.0);
    }
}

TEST(Huffman, lengthsStayWithinTheLimit)
{
    // Fibonacci counts make the deepest tree.
    std::vector<std::uint16_t> counts{1, 1};
    while (counts.size() < 19) {
        counts.push_back(static_cast<std::uint16_t>(counts.back() + counts[counts.size() - 2]));
    }
    std::vector<std::uint8_t> lengths(counts.size());
    huffmanLengths(counts, 7, lengths);
    EXPECT_EQ(*std::ranges::max_element(lengths), 7);
    double kraft = 0;
    for (const std::uint8_t length : lengths) {
        kraft += std::ldexp(1.0, -length);
    }
    EXPECT_EQ(kraft, 1.0);
}

TEST(Huffman, oneSymbolHasOneBitAndNoneHasNone)
{
    std::vector<std::uint8_t> lengths(3);
    huffmanLengths(std::vector<std::uint16_t>{0, 9, 0}, 15, lengths);
    EXPECT_EQ(lengths, (std::vector<std::uint8_t>{0, 1, 0}));
    huffmanLengths(std::vector<std::uint16_t>{0, 0, 0}, 15, lengths);
    EXPECT_EQ(lengths, (std::vector<std::uint8_t>{0, 0, 0}));
}

TEST(SmallDeflater, everySizeOfEveryKindOfContentRoundTrips)
{
    std::mt19937 random(5);
    const std::vector<std::function<unsigned(std::size_t)>> kinds{
        [](std::size_t) { return 0U; },
        [](std::size_t k) { return static_cast<unsigned>(k); },
        [](std::size_t k) { return static_cast<unsigned>(k % 7 == 0 ? 200 : 3); },
        [](std::size_t k) { return static_cast<unsigned>(k / 40); },
        [&](std::size_t) { return static_cast<unsigned>(random()); },
        [&](std::size_t) { return static_cast<unsigned>(random() % 5); },
        [&](std::size_t) {
            return static_cast<unsigned>(
                std::lround(std::normal_distribution<double>(0, 6)(random)));
        },
    };
    Zipper zipper;
    for (const auto& kind : kinds) {
        for (std::size_t size = 1; size <= SmallDeflater::kMaxBytes; size += size < 300 ? 1 : 83) {
            zipper.expectRoundTrip(generated(size, kind));
        }
        zipper.expectRoundTrip(generated(SmallDeflater::kMaxBytes, kind));
    }
}

TEST(SmallDeflater, patternsThatRepeatAtAnyDistanceRoundTrip)
{
    std::mt19937 random(11);
    Zipper zipper;
    for (int round = 0; round < 3000; ++round) {
        Bytes bytes = generated(1 + random() % 64, [&](std::size_t) { return random() % 9; });
        const std::size_t size = 1 + random() % SmallDeflater::kMaxBytes;
        while (bytes.size() < size) { // copies of earlier stretches, and now and then a new byte
            const std::size_t from = random() % bytes.size();
            const std::size_t count = std::min<std::size_t>(
                1 + random() % 300, std::min(size, bytes.size() + bytes.size()) - bytes.size());
            for (std::size_t k = 0; k < count; ++k) {
                bytes.push_back(bytes[from + k]);
            }
            bytes.push_back(static_cast<std::byte>(random()));
        }
        bytes.resize(size);
        zipper.expectRoundTrip(bytes);
    }
}

TEST(SmallDeflater, skewedCountsThatMakeDeepCodesRoundTrip)
{
    Bytes bytes;
    std::size_t a = 1;
    std::size_t b = 1;
    for (unsigned symbol = 0; bytes.size() + a <= SmallDeflater::kMaxBytes; ++symbol) {
        bytes.insert(bytes.end(), a, static_cast<std::byte>(symbol * 5));
        std::swap(a, b);
        b += a;
    }
    std::ranges::shuffle(bytes, std::mt19937(1));
    Zipper().expectRoundTrip(bytes);
}

TEST(SmallDeflater, equalBytesGiveEqualStreamsWhateverCameBefore)
{
    std::mt19937 random(2);
    const Bytes bytes =
        generated(500, [](std::size_t k) { return static_cast<unsigned>(k * k % 17); });
    Zipper fresh;
    const Bytes expected{fresh.zip(bytes).begin(), fresh.zip(bytes).end()};
    Zipper used;
    for (int k = 0; k < 100; ++k) {
        used.zip(generated(1 + random() % 2000, [&](std::size_t) { return random() % 17; }));
    }
    const auto stream = used.zip(bytes);
    EXPECT_TRUE(std::ranges::equal(stream, expected));
}

TEST(SmallDeflater, isNoLargerThanTheLibraryByMuch)
{
    std::mt19937 random(8);
    std::size_t own = 0;
    std::size_t zlib = 0;
    Zipper zipper;
    for (const double spread : {0.5, 2.0, 6.0, 20.0}) {
        for (const std::size_t size : {48U, 192U, 768U, 2048U}) {
            for (int k = 0; k < 20; ++k) {
                const Bytes bytes = generated(size, [&](std::size_t) {
                    return static_cast<unsigned>(
                        std::lround(std::normal_distribution<double>(0, spread)(random)));
                });
                own += zipper.zip(bytes).size();
                uLongf bound = compressBound(bytes.size());
                std::vector<Bytef> out(bound);
                compress2(out.data(),
                          &bound,
                          reinterpret_cast<const Bytef*>(bytes.data()),
                          bytes.size(),
                          6);
                zlib += bound;
            }
        }
    }
    EXPECT_LT(static_cast<double>(own), 1.02 * static_cast<double>(zlib));
}

TEST(SmallInflater, readsWhateverZlibWrites)
{
    std::mt19937 random(21);
    SmallInflater inflater;
    for (int round = 0; round < 4000; ++round) {
        const unsigned spread = 1U << (1 + random() % 8);
        const Bytes bytes = generated(1 + random() % SmallInflater::kMaxBytes, [&](std::size_t k) {
            return random() % 4 == 0 ? static_cast<unsigned>(k % 31) : random() % spread;
        });
        const std::vector<std::byte> stream = zippedByZlib(bytes, random);
        Bytes back(bytes.size());
        ASSERT_TRUE(inflater.unzip(stream, back));
        ASSERT_EQ(back, bytes);
        back.resize(bytes.size() + 1);
        ASSERT_FALSE(inflater.unzip(stream, back));                                    // too little
        ASSERT_FALSE(inflater.unzip(stream, std::span(back).first(bytes.size() - 1))); // too much
        for (std::size_t cut = 0; cut < stream.size(); cut += 1 + cut / 8) {
            ASSERT_FALSE(
                inflater.unzip(std::span(stream).first(cut), std::span(back).first(bytes.size())));
        }
    }
}

TEST(SmallInflater, agreesWithZlibOnDamagedStreams)
{
    std::mt19937 random(22);
    SmallInflater inflater;
    int accepted = 0;
    for (int round = 0; round < 40000; ++round) {
        const Bytes bytes =
            generated(1 + random() % 200, [&](std::size_t) { return random() % 9; });
        const std::vector<std::byte> stream = zippedByZlib(bytes, random);
        std::vector<std::byte> raw(stream.begin() + 2, stream.end() - 4);
        for (unsigned flips = 1 + random() % 2; flips > 0; --flips) {
            raw[random() % raw.size()] ^= std::byte{1} << (random() % 8);
        }
        const auto expected = samples::inflatedByZlib(raw, SmallInflater::kMaxBytes);
        Bytes back(expected ? expected->bytes.size() : bytes.size());
        if (expected) {
            raw.resize(expected->used); // what follows the last block is the checksum's place
        }
        const auto whole = samples::wrapped(raw, expected ? expected->bytes : bytes);
        ASSERT_EQ(inflater.unzip(whole, back), expected.has_value()) << round;
        if (expected) {
            ASSERT_EQ(back, expected->bytes);
            ++accepted;
        }
    }
    EXPECT_GT(accepted, 1000); // enough of both to mean something
    EXPECT_LT(accepted, 39000);
}

TEST(SmallInflater, wrongHeadersAndChecksumsAreRefused)
{
    Zipper zipper;
    const Bytes bytes = generated(100, [](std::size_t k) { return static_cast<unsigned>(k % 5); });
    const auto stream = zipper.zip(bytes);
    Bytes back(bytes.size());
    SmallInflater inflater;
    for (const std::size_t at : {std::size_t{0}, std::size_t{1}, stream.size() - 1}) {
        Bytes damaged(stream.begin(), stream.end());
        damaged[at] ^= std::byte{1};
        EXPECT_FALSE(inflater.unzip(damaged, back)) << at;
    }
}

TEST(Deflater, shortAndLongStretchesRoundTrip)
{
    Deflater deflater;
    std::mt19937 random(4);
    for (const std::size_t size : {0U, 1U, 48U, 2048U, 2049U, 70'000U, 3'000'000U}) {
        const Bytes bytes = generated(size, [&](std::size_t) { return random() % 30; });
        ASSERT_EQ(unzippedByZlib(deflater.zip(bytes), size), bytes);
    }
}
