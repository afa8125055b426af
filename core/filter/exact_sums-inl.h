// SPDX-License-Identifier: GPL-3.0-or-later
//
// Sums in double. Compiled once for each kind of processor (Highway).
#if defined(TRIXEL_EXACT_SUMS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef TRIXEL_EXACT_SUMS_INL_H
#undef TRIXEL_EXACT_SUMS_INL_H
#else
#define TRIXEL_EXACT_SUMS_INL_H
#endif

#include "core/filter/exact_kernel.h"

#include <hwy/contrib/math/math-inl.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace trixel {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using WeightTag = hn::CappedTag<double, 8>;

/// Sums of four channels.
#if HWY_TARGET == HWY_SCALAR
class ChannelSums
{
public:
    HWY_INLINE void add(double weight, const float* texel)
    {
        for (std::size_t c = 0; c < kGroupChannels; ++c) {
            m_sums[c] += weight * static_cast<double>(texel[c]);
        }
    }
    HWY_INLINE void addTo(std::array<double, kGroupChannels>& values, double factor) const
    {
        for (std::size_t c = 0; c < kGroupChannels; ++c) {
            values[c] += factor * m_sums[c];
        }
    }

private:
    std::array<double, kGroupChannels> m_sums{};
};
#else
// One register where it holds four doubles, else two.
#undef TRIXEL_FOUR_DOUBLES
#define TRIXEL_FOUR_DOUBLES (HWY_MAX_BYTES >= 32)
class ChannelSums
{
public:
    HWY_INLINE ChannelSums() // written out: an implied one is not compiled for the target
        : m_first(hn::Zero(Tag()))
#if !TRIXEL_FOUR_DOUBLES
        , m_second(hn::Zero(Tag()))
#endif
    {
    }
    HWY_INLINE void add(double weight, const float* texel)
    {
        const auto each = hn::Set(Tag(), weight);
        m_first = hn::MulAdd(each, values(texel), m_first);
#if !TRIXEL_FOUR_DOUBLES
        m_second = hn::MulAdd(each, values(texel + 2), m_second);
#endif
    }
    HWY_INLINE void addTo(std::array<double, kGroupChannels>& sums, double factor) const
    {
        addPart(sums.data(), factor, m_first);
#if !TRIXEL_FOUR_DOUBLES
        addPart(sums.data() + 2, factor, m_second);
#endif
    }

private:
    using Tag = hn::FixedTag<double, TRIXEL_FOUR_DOUBLES ? 4 : 2>;
    using FloatTag = hn::Rebind<float, Tag>;

    static HWY_INLINE hn::Vec<Tag> values(const float* part)
    {
        return hn::PromoteTo(Tag(), hn::LoadU(FloatTag(), part));
    }
    static HWY_INLINE void addPart(double* sums, double factor, hn::Vec<Tag> part)
    {
        const auto before = hn::LoadU(Tag(), sums);
        hn::StoreU(hn::MulAdd(hn::Set(Tag(), factor), part, before), Tag(), sums);
    }

    hn::Vec<Tag> m_first;
#if !TRIXEL_FOUR_DOUBLES
    hn::Vec<Tag> m_second;
#endif
};
#endif

} // namespace HWY_NAMESPACE
} // namespace trixel
HWY_AFTER_NAMESPACE();

#endif
