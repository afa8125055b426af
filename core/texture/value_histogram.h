// SPDX-License-Identifier: GPL-3.0-or-later
//
// How often each value occurs in a texture.
#pragma once

#include "core/base/parallel.h"
#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/texture/texel_store.h"

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace trixel {

/// How often each value of one number occurs among the texels of a store; a constant face counts
/// for all its texels. Integers and half are counted value by value; float and weighted sums in
/// buckets of a relative width of 1/128, so that what is asked of the order of values is then close
/// but not exact (`isExact`).
class ValueHistogram
{
public:
    /// Finite values of one stored value or bucket.
    struct Bucket
    {
        float value = 0; ///< that stands for it: the value itself, or the middle of the bucket
        float from = 0;  ///< what it spreads over when drawn, beside its neighbours
        float to = 0;    ///< greater than `from`
        std::uint64_t count = 0;
        std::uint64_t nearest = 0; ///< of these are exactly the end that is nearer to zero

        bool operator==(const Bucket&) const = default;
    };

    /// Numbers that are no finite values, and the ends of those that are; always exact.
    struct Summary
    {
        std::uint64_t total = 0; ///< texels
        std::uint64_t notANumber = 0;
        std::uint64_t infinite = 0; ///< of either sign
        std::uint64_t negative = 0; ///< finite ones below zero
        float least = 0;            ///< finite; 0 where there is none
        float greatest = 0;

        std::uint64_t finite() const { return total - notANumber - infinite; }
        bool operator==(const Summary&) const = default;
    };

    ValueHistogram() = default;
    /// \param buckets  in the order of their values, without empty ones
    ValueHistogram(const Summary& summary, std::vector<Bucket> buckets, bool isExact);

    const Summary& summary() const { return m_summary; }
    std::span<const Bucket> buckets() const { return m_buckets; }
    bool isExact() const { return m_isExact; }

    /// Finite values greater than one.
    std::uint64_t above(float value) const;
    /// Whether `above` is exact for it; of buckets it is at their ends: at numbers of seven binary
    /// digits after the first, such as 0, 0.75, 1 and every power of two.
    bool isExactAbove(float value) const;
    /// The value that this share of the finite ones does not exceed; nothing where there are none.
    /// \param share  in [0, 1]: 0 is the least value, 1 the greatest
    std::optional<float> quantile(double share) const;
    /// How many finite values lie in each of `count` equal parts of a range; what spreads over
    /// several is shared out by width. Values outside count nowhere.
    /// \param low, high  finite, low < high (checked)
    std::vector<double> parts(float low, float high, std::size_t count) const;

private:
    Summary m_summary;
    std::vector<Bucket> m_buckets;
    bool m_isExact = true;
};

/// A number that a texel has: one of its channels, or a weighted sum of the first three.
struct TexelNumber
{
    std::uint16_t channel = 0;
    std::optional<std::array<float, 3>> weights; ///< a sum by these, whatever `channel` says

    bool operator==(const TexelNumber&) const = default;
};

/// Counts the values of several numbers over all texels. Time on one core: 0.7 ns a texel and number
/// of bytes, 3.5 ns of floats, constant faces as one texel. Fails only when cancelled.
/// \param numbers  channels that the format has (checked), sums of three or more (checked)
/// \return         a histogram for each
Result<std::vector<ValueHistogram>> countValues(const TexelStore& store,
                                                std::span<const TexelNumber> numbers,
                                                Threads threads,
                                                Progress& progress);

} // namespace trixel
