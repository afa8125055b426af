// SPDX-License-Identifier: GPL-3.0-or-later
//
// Texels under a window, weighed and summed many at a time. Compiled once for each kind of
// processor (Highway).
#if defined(TRIXEL_WINDOW_TAPS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef TRIXEL_WINDOW_TAPS_INL_H
#undef TRIXEL_WINDOW_TAPS_INL_H
#else
#define TRIXEL_WINDOW_TAPS_INL_H
#endif

#include "core/filter/ewa_kernel.h"

#include <cstdint>
#include <hwy/cache_control.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace trixel {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// Four texels of four channels: one register where there are wide ones.
using WideTag = hn::CappedTag<float, 16>;

/// The window's formula, on vectors.
class WindowVectors
{
public:
    explicit WindowVectors(const GaussianWindow& window)
        : m_inverse(static_cast<float>(1 / (window.cut() * window.cut())))
        , m_pedestal(static_cast<float>(window.pedestal()))
    {
    }

    template <class D>
    HWY_INLINE hn::Vec<D> weight(D d, hn::Vec<D> q) const
    {
        const auto r = hn::Mul(q, hn::Set(d, m_inverse));
        const auto r2 = hn::Mul(r, r);
        const auto rim = hn::Mul(r2, hn::Set(d, m_pedestal));
        const auto whole = negativeExponential(d, hn::Mul(q, hn::Set(d, 0.5F)));
        return hn::Max(hn::NegMulAdd(r2, rim, whole), hn::Zero(d));
    }

private:
    /// As `GaussianWindow::negativeExponential`.
    template <class D>
    static HWY_INLINE hn::Vec<D> negativeExponential(D d, hn::Vec<D> x)
    {
        const auto y = hn::Mul(x, hn::Set(d, 0.125F));
        auto e = hn::NegMulAdd(y, hn::Set(d, 1.0F / 720.0F), hn::Set(d, 1.0F / 120.0F));
        e = hn::NegMulAdd(y, e, hn::Set(d, 1.0F / 24.0F));
        e = hn::NegMulAdd(y, e, hn::Set(d, 1.0F / 6.0F));
        e = hn::NegMulAdd(y, e, hn::Set(d, 0.5F));
        e = hn::NegMulAdd(y, e, hn::Set(d, 1.0F));
        e = hn::NegMulAdd(y, e, hn::Set(d, 1.0F));
        e = hn::Mul(e, e);
        e = hn::Mul(e, e);
        return hn::Mul(e, e);
    }

    float m_inverse, m_pedestal;
};

/// Lane of four that each of sixteen repeats.
alignas(64) inline constexpr std::int32_t kFourEach[16] = {
    0, 0, 0, 0, 1, 1, 1, 1, 2, 2, 2, 2, 3, 3, 3, 3};

/// Sums of weighted texels, of four of them in a row at a time: one register where there are wide
/// ones.
class ChannelSums
{
public:
    HWY_INLINE explicit ChannelSums(const GroupValue& reference)
        : m_reference(reference)
#if HWY_TARGET != HWY_SCALAR
        , m_four(hn::Zero(WideTag()))
        , m_one(hn::Zero(OneTag()))
#endif
    {
    }

    /// Texels that follow each other. A weight of 0 keeps even a NaN out.
    /// \param weights  four, aligned to 16 bytes
    HWY_INLINE void addFour(const float* weights, const float* texels)
    {
#if HWY_TARGET == HWY_SCALAR
        for (std::uint32_t k = 0; k < 4; ++k) {
            if (weights[k] != 0) {
                addOne(weights[k], texels + kGroupChannels * k);
            }
        }
#else
        constexpr WideTag d;
        const auto all = hn::LoadDup128(d, weights);
        const auto reference = hn::LoadDup128(d, m_reference.data());
        for (std::size_t k = 0; k < 16; k += hn::Lanes(d)) {
            const auto w = hn::TableLookupLanes(all, hn::SetTableIndices(d, kFourEach + k));
            const auto beyond = hn::Sub(hn::LoadU(d, texels + k), reference);
            m_four = hn::MulAdd(w, hn::IfThenElseZero(hn::Gt(w, hn::Zero(d)), beyond), m_four);
        }
#endif
    }

    HWY_INLINE void addOne(float weight, const float* texel)
    {
#if HWY_TARGET == HWY_SCALAR
        for (std::size_t c = 0; c < kGroupChannels; ++c) {
            m_sums[c] += weight * (texel[c] - m_reference[c]);
        }
#else
        m_one = hn::MulAdd(hn::Set(OneTag(), weight), beyond(texel), m_one);
#endif
    }

    /// \param factor  of every sum
    HWY_INLINE void addTo(WindowSums& sums, double factor) const
    {
#if HWY_TARGET == HWY_SCALAR
        for (std::size_t c = 0; c < kGroupChannels; ++c) {
            sums.values[c] += factor * static_cast<double>(m_sums[c]);
        }
#else
        HWY_ALIGN float four[16];
        HWY_ALIGN float one[kGroupChannels];
        hn::Store(m_four, WideTag(), four);
        hn::Store(m_one, OneTag(), one);
        for (std::size_t c = 0; c < kGroupChannels; ++c) {
            sums.values[c] += factor * static_cast<double>(one[c]);
            for (std::size_t k = c; k < hn::Lanes(WideTag()); k += kGroupChannels) {
                sums.values[c] += factor * static_cast<double>(four[k]);
            }
        }
#endif
    }

    /// The same, and begins anew.
    HWY_INLINE void moveTo(WindowSums& sums)
    {
        addTo(sums, 1);
#if HWY_TARGET == HWY_SCALAR
        m_sums = {};
#else
        m_four = hn::Zero(WideTag());
        m_one = hn::Zero(OneTag());
#endif
    }

private:
    const GroupValue& m_reference;
#if HWY_TARGET == HWY_SCALAR
    GroupValue m_sums{};
#else
    using OneTag = hn::FixedTag<float, kGroupChannels>;

    HWY_INLINE hn::Vec<OneTag> beyond(const float* texel) const
    {
        return hn::Sub(hn::LoadU(OneTag(), texel), hn::LoadU(OneTag(), m_reference.data()));
    }

    hn::Vec<WideTag> m_four;
    hn::Vec<OneTag> m_one;
#endif
};

} // namespace HWY_NAMESPACE
} // namespace trixel
HWY_AFTER_NAMESPACE();

#endif
