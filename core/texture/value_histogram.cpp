// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/texture/value_histogram.h"

#include "core/base/check.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

namespace trixel {

namespace {

constexpr double kLeastNormal = double{std::numeric_limits<float>::min()};

} // namespace

ValueHistogram::ValueHistogram(const Summary& summary, std::vector<Bucket> buckets, bool isExact)
    : m_summary(summary)
    , m_buckets(std::move(buckets))
    , m_isExact(isExact)
{
}

std::uint64_t ValueHistogram::above(float value) const
{
    // NaN is not above anything, and nothing is above NaN.
    if (!(value < m_summary.greatest)) {
        return 0;
    }
    std::uint64_t count = 0;
    for (auto bucket = m_buckets.rbegin(); bucket != m_buckets.rend(); ++bucket) {
        if (m_isExact ? bucket->value <= value : bucket->to <= value) {
            break;
        }
        if (m_isExact || bucket->from > value || (bucket->from == value && bucket->to <= 0)) {
            count += bucket->count;
        } else if (bucket->from == value) {
            count += bucket->count - bucket->nearest;
        } else {
            const double share = (double{bucket->to} - value) / (double{bucket->to} - bucket->from);
            count += static_cast<std::uint64_t>(
                std::llround(share * static_cast<double>(bucket->count)));
        }
    }
    return count;
}

bool ValueHistogram::isExactAbove(float value) const
{
    return m_isExact || (std::bit_cast<std::uint32_t>(value) & 0xffffU) == 0;
}

std::optional<float> ValueHistogram::quantile(double share) const
{
    check(share >= 0 && share <= 1, "a share");
    if (m_buckets.empty()) {
        return std::nullopt;
    }
    const double wanted = share * static_cast<double>(m_summary.finite());
    double before = 0;
    for (const Bucket& bucket : m_buckets) {
        const auto count = static_cast<double>(bucket.count);
        if (before + count >= wanted) {
            if (m_isExact) {
                return bucket.value;
            }
            const double within = (wanted - before) / count;
            const double value = bucket.from + within * (double{bucket.to} - bucket.from);
            // Within the bucket of zero there is as good as nothing but zero.
            const double usual = std::abs(value) < kLeastNormal ? 0 : value;
            return std::clamp(static_cast<float>(usual), m_summary.least, m_summary.greatest);
        }
        before += count;
    }
    return m_summary.greatest;
}

std::vector<double> ValueHistogram::parts(float low, float high, std::size_t count) const
{
    check(low < high && std::isfinite(low) && std::isfinite(high), "a range");
    std::vector<double> parts(count);
    const double scale = static_cast<double>(count) / (double{high} - low);
    const auto begin = std::ranges::lower_bound(m_buckets, low, {}, &Bucket::to);
    for (auto bucket = begin; bucket != m_buckets.end() && bucket->from < high; ++bucket) {
        const double from = (double{bucket->from} - low) * scale;
        const double to = (double{bucket->to} - low) * scale;
        const double perPart = static_cast<double>(bucket->count) / (to - from);
        const double first = std::max(from, 0.0);
        const double end = std::min(to, static_cast<double>(count));
        for (auto k = static_cast<std::size_t>(first); k < count; ++k) {
            const auto place = static_cast<double>(k);
            if (place >= end) {
                break;
            }
            parts[k] += perPart * (std::min(end, place + 1) - std::max(first, place));
        }
    }
    return parts;
}

} // namespace trixel
