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
class ChannelSums
{
public:
    HWY_INLINE ChannelSums() // written out: an implied one is not compiled for the target
        : m_first(hn::Zero(Tag()))
        , m_second(hn::Zero(Tag()))
    {
    }
    HWY_INLINE void add(double weight, const float* texel)
    {
        const auto both = hn::Set(Tag(), weight);
        m_first = hn::MulAdd(both, values(texel), m_first);
        m_second = hn::MulAdd(both, values(texel + 2), m_second);
    }
    HWY_INLINE void addTo(std::array<double, kGroupChannels>& sums, double factor) const
    {
        addHalf(sums.data(), factor, m_first);
        addHalf(sums.data() + 2, factor, m_second);
    }

private:
    using Tag = hn::FixedTag<double, 2>;
    using FloatTag = hn::FixedTag<float, 2>;

    static HWY_INLINE hn::Vec<Tag> values(const float* two)
    {
        return hn::PromoteTo(Tag(), hn::LoadU(FloatTag(), two));
    }
    static HWY_INLINE void addHalf(double* sums, double factor, hn::Vec<Tag> half)
    {
        const auto before = hn::LoadU(Tag(), sums);
        hn::StoreU(hn::MulAdd(hn::Set(Tag(), factor), half, before), Tag(), sums);
    }

    hn::Vec<Tag> m_first;
    hn::Vec<Tag> m_second;
};
#endif

} // namespace HWY_NAMESPACE
} // namespace trixel
HWY_AFTER_NAMESPACE();

#endif
