// SPDX-License-Identifier: GPL-3.0-or-later
//
// The counting behind value_histogram.h: a table of 256 or 65536 entries for each number and
// thread. A float counts by the upper half of its bits, which order as its values do.
#include "core/base/check.h"
#include "core/texture/pinned_face.h"
#include "core/texture/texel_codec.h"
#include "core/texture/value_histogram.h"

#include <algorithm>
#include <atomic>
#include <bit>
#include <cmath>
#include <limits>
#include <memory>
#include <mutex>
#include <numeric>
#include <utility>

namespace trixel {

namespace {

/// Texels that are counted before another number's table is gone to: they stay in the cache.
constexpr std::size_t kBatchTexels = 8192;
/// Texels of one piece of work.
constexpr std::size_t kPieceTexels = 1U << 17U;

constexpr std::uint32_t kSign = 0x80000000U;
constexpr std::uint32_t kExponent = 0x7f800000U;

/// What was counted of one number.
struct Tally
{
    std::vector<std::uint64_t> table;   ///< by stored value, or by a float's upper half
    std::vector<std::uint64_t> nearest; ///< of floats, those whose lower half is zero
    std::uint64_t notANumber = 0;       ///< this and the following for floats; else from the table
    std::uint64_t infinite = 0;
    std::uint64_t negative = 0;
    float least = std::numeric_limits<float>::infinity();
    float greatest = -std::numeric_limits<float>::infinity();

    void add(float value, std::uint64_t times)
    {
        const auto bits = std::bit_cast<std::uint32_t>(value);
        if ((bits & kExponent) == kExponent) {
            ((bits & ~(kExponent | kSign)) != 0 ? notANumber : infinite) += times;
            return;
        }
        table[bits >> 16U] += times;
        nearest[bits >> 16U] += (bits & 0xffffU) == 0 ? times : 0;
        negative += value < 0 ? times : 0;
        least = std::min(least, value);
        greatest = std::max(greatest, value);
    }

    void add(const Tally& other)
    {
        for (std::size_t k = 0; k < table.size(); ++k) {
            table[k] += other.table[k];
        }
        for (std::size_t k = 0; k < nearest.size(); ++k) {
            nearest[k] += other.nearest[k];
        }
        notANumber += other.notANumber;
        infinite += other.infinite;
        negative += other.negative;
        least = std::min(least, other.least);
        greatest = std::max(greatest, other.greatest);
    }
};

using Tallies = std::vector<Tally>;

/// Counts one number of stored texels.
using Counter = void (*)(const TexelNumber& number,
                         std::size_t channels,
                         std::span<const std::byte> texels,
                         std::uint64_t times,
                         Tally& tally);

template <TexelType Type>
void countChannel(const TexelNumber& number,
                  std::size_t channels,
                  std::span<const std::byte> texels,
                  std::uint64_t times,
                  Tally& tally)
{
    using Stored = typename TexelCodec<Type>::Stored;
    const std::size_t count = texels.size() / (channels * sizeof(Stored));
    for (std::size_t k = 0; k < count; ++k) {
        const auto value = loadStored<Stored>(texels.data(), k * channels + number.channel);
        if constexpr (Type == TexelType::Float) {
            tally.add(value, times);
        } else {
            tally.table[value] += times;
        }
    }
}

template <TexelType Type>
void countSum(const TexelNumber& number,
              std::size_t channels,
              std::span<const std::byte> texels,
              std::uint64_t times,
              Tally& tally)
{
    using Codec = TexelCodec<Type>;
    using Stored = typename Codec::Stored;
    const std::array<float, 3> weights = *number.weights;
    const std::size_t count = texels.size() / (channels * sizeof(Stored));
    for (std::size_t k = 0; k < count; ++k) {
        const auto value = [&](std::size_t c) {
            return Codec::decoded(loadStored<Stored>(texels.data(), k * channels + c));
        };
        tally.add(weights[0] * value(0) + weights[1] * value(1) + weights[2] * value(2), times);
    }
}

Counter counterOf(TexelType type, const TexelNumber& number)
{
    return withTexelType(type, [&](auto constant) -> Counter {
        constexpr TexelType kType = decltype(constant)::value;
        return number.weights ? &countSum<kType> : &countChannel<kType>;
    });
}

bool countsAsFloat(TexelType type, const TexelNumber& number)
{
    return number.weights || type == TexelType::Float;
}

Tallies emptyTallies(TexelType type, std::span<const TexelNumber> numbers)
{
    Tallies tallies(numbers.size());
    for (std::size_t n = 0; n < numbers.size(); ++n) {
        const bool isByte = !countsAsFloat(type, numbers[n]) && type == TexelType::UInt8;
        tallies[n].table.resize(isByte ? 0x100U : 0x10000U);
        tallies[n].nearest.resize(countsAsFloat(type, numbers[n]) ? 0x10000U : 0);
    }
    return tallies;
}

/// Lends tallies to whatever thread counts: as many are made as threads count at a time.
class TallyPool
{
public:
    TallyPool(TexelType type, std::span<const TexelNumber> numbers)
        : m_type(type)
        , m_numbers(numbers)
    {
    }

    std::unique_ptr<Tallies> take()
    {
        const std::scoped_lock lock(m_mutex);
        if (m_free.empty()) {
            return std::make_unique<Tallies>(emptyTallies(m_type, m_numbers));
        }
        std::unique_ptr<Tallies> tallies = std::move(m_free.back());
        m_free.pop_back();
        return tallies;
    }

    void giveBack(std::unique_ptr<Tallies> tallies)
    {
        const std::scoped_lock lock(m_mutex);
        m_free.push_back(std::move(tallies));
    }

    /// All of them together, when all were given back.
    Tallies sum()
    {
        Tallies whole = emptyTallies(m_type, m_numbers);
        for (const auto& part : m_free) {
            for (std::size_t n = 0; n < whole.size(); ++n) {
                whole[n].add((*part)[n]);
            }
        }
        return whole;
    }

private:
    TexelType m_type;
    std::span<const TexelNumber> m_numbers;
    std::mutex m_mutex;
    std::vector<std::unique_ptr<Tallies>> m_free;
};

/// Texels of consecutive faces, or a part of one large face.
struct Piece
{
    std::size_t firstFace = 0;
    std::size_t endFace = 0;
    std::size_t firstTexel = 0; ///< of a face alone
    std::size_t endTexel = 0;   ///< 0: all texels of the faces
};

std::vector<Piece> piecesOf(const TexelStore& store)
{
    std::vector<Piece> pieces;
    Piece open;
    std::size_t texels = 0;
    const auto close = [&](std::size_t end) {
        if (open.firstFace < end) {
            open.endFace = end;
            pieces.push_back(open);
        }
        open.firstFace = end;
        texels = 0;
    };
    for (std::size_t f = 0; f < store.faceCount(); ++f) {
        const FaceTexels& face = store.face(faceId(f));
        const std::size_t count = face.isConstant() ? 1 : face.level().texelCount();
        if (count > kPieceTexels) {
            close(f);
            for (std::size_t first = 0; first < count; first += kPieceTexels) {
                pieces.push_back({f, f + 1, first, std::min(count, first + kPieceTexels)});
            }
            open.firstFace = f + 1;
        } else if ((texels += count + 4) >= kPieceTexels) { // a face itself costs some texels
            close(f + 1);
        }
    }
    close(store.faceCount());
    return pieces;
}

/// What is the same for all pieces.
class Counting
{
public:
    Counting(const TexelStore& store, std::span<const TexelNumber> numbers)
        : m_store(store)
        , m_numbers(numbers)
    {
        for (const TexelNumber& number : numbers) {
            m_counters.push_back(counterOf(store.format().type, number));
        }
    }

    void count(const Piece& piece, Tallies& tallies) const
    {
        for (std::size_t f = piece.firstFace; f < piece.endFace; ++f) {
            const PinnedFace pin(m_store.face(faceId(f)));
            const FaceTexels& face = *pin;
            if (face.isConstant()) {
                count(face.bytes(), face.level().texelCount(), tallies);
                continue;
            }
            const std::size_t end = piece.endTexel > 0 ? piece.endTexel : face.level().texelCount();
            for (std::size_t first = piece.firstTexel; first < end; first += kBatchTexels) {
                const std::size_t texels = std::min(kBatchTexels, end - first);
                count(face.bytes().subspan(first * face.texelBytes(), texels * face.texelBytes()),
                      1,
                      tallies);
            }
        }
    }

private:
    void count(std::span<const std::byte> texels, std::uint64_t times, Tallies& tallies) const
    {
        for (std::size_t n = 0; n < m_numbers.size(); ++n) {
            m_counters[n](m_numbers[n], m_store.format().channels, texels, times, tallies[n]);
        }
    }

    const TexelStore& m_store;
    std::span<const TexelNumber> m_numbers;
    std::vector<Counter> m_counters;
};

/// Moves a tally of half values into the form of floats: the table keeps finite ones alone.
void sortOutHalves(Tally& tally)
{
    for (std::size_t key = 0; key < tally.table.size(); ++key) {
        if ((key & 0x7c00U) == 0x7c00U) {
            ((key & 0x3ffU) != 0 ? tally.notANumber : tally.infinite) +=
                std::exchange(tally.table[key], 0);
        }
    }
}

/// The finite bucket of a table's entry. Halves and floats spread towards the next one that is
/// further from zero.
ValueHistogram::Bucket bucketOf(TexelType type, bool isFloat, std::size_t key, std::uint64_t count)
{
    const auto magnitudes = [&](float nearer, float further, bool isNegative) {
        return isNegative ? std::pair(-further, -nearer) : std::pair(nearer, further);
    };
    if (isFloat) {
        const auto low = static_cast<std::uint32_t>(key & 0x7fffU) << 16U;
        const std::uint32_t high = std::min(low + 0x10000U, kExponent - 1);
        const auto [from, to] =
            magnitudes(std::bit_cast<float>(low), std::bit_cast<float>(high), (key & 0x8000U) != 0);
        return {std::midpoint(from, to), from, to, count, 0};
    }
    if (type == TexelType::Half) {
        const auto low = static_cast<std::uint16_t>(key & 0x7fffU);
        const float nearer = imath_half_to_float(low);
        const float further =
            low + 1 < 0x7c00 ? imath_half_to_float(static_cast<std::uint16_t>(low + 1)) : 65536.0F;
        const bool isNegative = (key & 0x8000U) != 0;
        const auto [from, to] = magnitudes(nearer, further, isNegative);
        return {isNegative ? -nearer : nearer, from, to, count, 0};
    }
    const float top = type == TexelType::UInt8 ? 255.0F : 65535.0F;
    const auto value = static_cast<float>(key);
    return {value / top, (value - 0.5F) / top, (value + 0.5F) / top, count, 0};
}

ValueHistogram histogramOf(TexelType type, bool isFloat, std::uint64_t total, Tally tally)
{
    if (type == TexelType::Half && !isFloat) {
        sortOutHalves(tally);
    }
    std::vector<ValueHistogram::Bucket> buckets;
    const auto take = [&](std::size_t key) {
        if (tally.table[key] > 0) {
            buckets.push_back(bucketOf(type, isFloat, key, tally.table[key]));
            buckets.back().nearest = isFloat ? tally.nearest[key] : 0;
        }
    };
    const bool isSigned = isFloat || type == TexelType::Half;
    const std::size_t positives = isSigned ? tally.table.size() / 2 : tally.table.size();
    for (std::size_t key = tally.table.size(); key > positives; --key) {
        take(key - 1); // the further from zero, the smaller
    }
    for (std::size_t key = 0; key < positives; ++key) {
        take(key);
    }
    ValueHistogram::Summary summary;
    summary.total = total;
    summary.notANumber = tally.notANumber;
    summary.infinite = tally.infinite;
    if (isFloat) {
        summary.negative = tally.negative;
    } else {
        for (const ValueHistogram::Bucket& bucket : buckets) {
            summary.negative += bucket.value < 0 ? bucket.count : 0;
        }
    }
    if (!buckets.empty()) {
        summary.least = isFloat ? tally.least : buckets.front().value;
        summary.greatest = isFloat ? tally.greatest : buckets.back().value;
    }
    return {summary, std::move(buckets), !isFloat};
}

} // namespace

Result<std::vector<ValueHistogram>> countValues(const TexelStore& store,
                                                std::span<const TexelNumber> numbers,
                                                Threads threads,
                                                Progress& progress)
{
    const TexelFormat& format = store.format();
    for (const TexelNumber& number : numbers) {
        check(number.weights ? format.channels >= 3 : number.channel < format.channels,
              "a number that texels have");
    }
    const std::vector<Piece> pieces = piecesOf(store);
    const Counting counting(store, numbers);
    TallyPool pool(format.type, numbers);
    std::mutex reporting;
    std::size_t done = 0;
    std::atomic<bool> isCancelled{!progress.report(0)};
    parallelFor(pieces.size(), 1, threads, [&](std::size_t begin, std::size_t end) {
        std::unique_ptr<Tallies> tallies = pool.take();
        for (std::size_t p = begin; p < end && !isCancelled; ++p) {
            counting.count(pieces[p], *tallies);
            const std::scoped_lock lock(reporting);
            const double fraction =
                static_cast<double>(++done) / static_cast<double>(pieces.size());
            if (!isCancelled && !progress.report(fraction)) {
                isCancelled = true;
            }
        }
        pool.giveBack(std::move(tallies));
    });
    if (isCancelled) {
        return cancelled();
    }
    Tallies tallies = pool.sum();
    std::vector<ValueHistogram> histograms;
    histograms.reserve(numbers.size());
    for (std::size_t n = 0; n < numbers.size(); ++n) {
        histograms.push_back(histogramOf(format.type,
                                         countsAsFloat(format.type, numbers[n]),
                                         store.texelCount(),
                                         std::move(tallies[n])));
    }
    return histograms;
}

} // namespace trixel
