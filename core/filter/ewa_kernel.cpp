// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/filter/ewa_kernel.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/filter/ewa_kernel.cpp"
#include <hwy/foreach_target.h> // includes this file once for each target
// After it:
#include "core/filter/lattice_rows-inl.h"

#include <hwy/cache_control.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace trixel {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using WeightTag = hn::CappedTag<float, 8>;

/// Sums of four channels.
#if HWY_TARGET == HWY_SCALAR
class ChannelSums
{
public:
    HWY_INLINE void add(float weight, const float* texel, const GroupValue& reference)
    {
        for (std::size_t c = 0; c < kGroupChannels; ++c) {
            m_sums[c] += weight * (texel[c] - reference[c]);
        }
    }
    HWY_INLINE void moveTo(WindowSums& sums)
    {
        for (std::size_t c = 0; c < kGroupChannels; ++c) {
            sums.values[c] += static_cast<double>(m_sums[c]);
        }
        m_sums = {};
    }

private:
    GroupValue m_sums{};
};
#else
class ChannelSums
{
public:
    HWY_INLINE ChannelSums() // written out: an implied one is not compiled for the target
        : m_sums(hn::Zero(Tag()))
    {
    }
    HWY_INLINE void add(float weight, const float* texel, const GroupValue& reference)
    {
        const auto beyond = hn::Sub(hn::LoadU(Tag(), texel), hn::LoadU(Tag(), reference.data()));
        m_sums = hn::MulAdd(hn::Set(Tag(), weight), beyond, m_sums);
    }
    HWY_INLINE void moveTo(WindowSums& sums)
    {
        GroupValue values;
        hn::StoreU(m_sums, Tag(), values.data());
        for (std::size_t c = 0; c < kGroupChannels; ++c) {
            sums.values[c] += static_cast<double>(values[c]);
        }
        m_sums = hn::Zero(Tag());
    }

private:
    using Tag = hn::FixedTag<float, kGroupChannels>;
    hn::Vec<Tag> m_sums;
};
#endif

/// The window's formula, on vectors.
class WindowVectors
{
public:
    explicit WindowVectors(const GaussianWindow& window)
        : m_inverse(static_cast<float>(1 / (window.cut() * window.cut())))
        , m_pedestal(static_cast<float>(window.pedestal()))
    {
    }

    HWY_INLINE hn::Vec<WeightTag> weight(hn::Vec<WeightTag> q) const
    {
        constexpr WeightTag d;
        const auto r = hn::Mul(q, hn::Set(d, m_inverse));
        const auto r2 = hn::Mul(r, r);
        const auto rim = hn::Mul(hn::Mul(r2, r2), hn::Set(d, m_pedestal));
        return hn::Max(hn::Sub(negativeExponential(hn::Mul(q, hn::Set(d, 0.5F))), rim),
                       hn::Zero(d));
    }

private:
    /// As `GaussianWindow::negativeExponential`.
    static HWY_INLINE hn::Vec<WeightTag> negativeExponential(hn::Vec<WeightTag> x)
    {
        constexpr WeightTag d;
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

/// A run as the inner loop wants it.
struct WindowRun
{
    const float* texel;
    std::uint32_t count;
    float height2, foot, step;
};

/// Runs wait here so that their texels are on the way from memory when their turn comes.
class WaitingRuns
{
public:
    WaitingRuns(const LevelTexels& texels,
                const GaussianWindow& window,
                const GroupValue& reference)
        : m_texels(texels)
        , m_window(window)
        , m_reference(reference)
        , m_weight(hn::Zero(WeightTag()))
    {
    }

    HWY_INLINE void add(const TexelRun& run, float step)
    {
        if (m_count == kRoom) {
            flush();
        }
        const float* texel = m_texels.values + std::size_t{m_texels.stride} * run.first;
        hwy::Prefetch(texel);
        hwy::Prefetch(texel + std::size_t{m_texels.stride} * (run.count - 1));
        m_runs[m_count++] = {texel,
                             run.count,
                             static_cast<float>(run.height * run.height),
                             static_cast<float>(run.foot),
                             step};
        m_taps += run.count;
    }

    HWY_INLINE void addTo(WindowSums& sums)
    {
        flush();
        spill();
        for (std::size_t c = 0; c < kGroupChannels; ++c) {
            sums.values[c] += m_spilled.values[c];
        }
        sums.weight += m_spilled.weight;
        sums.taps += m_taps;
    }

private:
    static constexpr std::uint32_t kRoom = 32;
    static constexpr std::uint32_t kChunk = 64; ///< weights at a time
    static constexpr std::uint32_t kMostInFloat = 4096;

    HWY_INLINE void flush()
    {
        for (std::uint32_t r = 0; r < m_count; ++r) {
            WindowRun run = m_runs[r];
            for (; run.count > kChunk; run.count -= kChunk) {
                addChunk(run, kChunk);
                run.texel += std::size_t{m_texels.stride} * kChunk;
                run.foot -= kChunk;
            }
            addChunk(run, run.count);
        }
        m_count = 0;
        if (m_taps - m_spilled.taps > kMostInFloat) {
            spill();
        }
    }

    /// Takes the sums in float over into those in double.
    HWY_INLINE void spill()
    {
        m_even.moveTo(m_spilled);
        m_odd.moveTo(m_spilled);
        m_spilled.weight += static_cast<double>(hn::GetLane(hn::SumOfLanes(WeightTag(), m_weight)));
        m_spilled.taps = m_taps;
        m_weight = hn::Zero(WeightTag());
    }

    HWY_INLINE void addChunk(const WindowRun& run, std::uint32_t count)
    {
        constexpr WeightTag d;
        const auto lanes = static_cast<std::uint32_t>(hn::Lanes(d));
        HWY_ALIGN float weights[kChunk];
        for (std::uint32_t k = 0; k < count; k += lanes) {
            const auto at = hn::Iota(d, static_cast<float>(k));
            const auto s = hn::Mul(hn::Sub(at, hn::Set(d, run.foot)), hn::Set(d, run.step));
            const auto all = m_window.weight(hn::MulAdd(s, s, hn::Set(d, run.height2)));
            const auto w = hn::IfThenElseZero(hn::FirstN(d, count - k), all);
            m_weight = hn::Add(m_weight, w);
            hn::Store(w, d, weights + k);
        }
        const std::size_t stride = m_texels.stride;
        const float* texel = run.texel;
        std::uint32_t k = 0;
        for (; k + 1 < count; k += 2, texel += 2 * stride) {
            m_even.add(weights[k], texel, m_reference);
            m_odd.add(weights[k + 1], texel + stride, m_reference);
        }
        if (k < count) {
            m_even.add(weights[k], texel, m_reference);
        }
    }

    const LevelTexels& m_texels;
    WindowVectors m_window;
    const GroupValue& m_reference;
    std::array<WindowRun, kRoom> m_runs;
    std::uint32_t m_count = 0;
    std::uint32_t m_taps = 0;
    WindowSums m_spilled;
    // Two chains of sums, for one waits for its own last addition.
    ChannelSums m_even, m_odd;
    hn::Vec<WeightTag> m_weight;
};

void addUnderWindow(const LevelTexels& texels,
                    const std::array<HalfLattice, 2>& halves,
                    const GaussianWindow& window,
                    const GroupValue& reference,
                    WindowSums& sums)
{
    WaitingRuns runs(texels, window, reference);
    for (const HalfLattice& half : halves) {
        const auto step = static_cast<float>(glm::length(half.alongRow));
        forRunsInCircle(
            half, window.cut(), [&](const TexelRun& run) HWY_ATTR { runs.add(run, step); });
    }
    runs.addTo(sums);
}

void addFewUnderWindow(const LevelTexels& texels,
                       const FewTexels& few,
                       const GaussianWindow& window,
                       const GroupValue& reference,
                       WindowSums& sums)
{
    constexpr WeightTag d;
    const auto lanes = static_cast<std::uint32_t>(hn::Lanes(d));
    const WindowVectors vectors(window);
    const auto cut2 = hn::Set(d, static_cast<float>(window.cut() * window.cut()));
    HWY_ALIGN float weights[kFewTexels];
    auto weight = hn::Zero(d);
    for (std::uint32_t k = 0; k < few.count; k += lanes) {
        const auto u = hn::LoadU(d, few.u + k);
        const auto v = hn::LoadU(d, few.v + k);
        const auto x = hn::MulAdd(u,
                                  hn::Set(d, few.perU.x),
                                  hn::MulAdd(v, hn::Set(d, few.perV.x), hn::Set(d, few.corner.x)));
        const auto y = hn::MulAdd(u,
                                  hn::Set(d, few.perU.y),
                                  hn::MulAdd(v, hn::Set(d, few.perV.y), hn::Set(d, few.corner.y)));
        const auto q = hn::MulAdd(x, x, hn::Mul(y, y));
        const auto near = hn::And(hn::Le(q, cut2), hn::FirstN(d, few.count - k));
        const auto w = hn::IfThenElseZero(near, vectors.weight(q));
        sums.taps += static_cast<std::uint32_t>(hn::CountTrue(d, near));
        weight = hn::Add(weight, w);
        hn::Store(w, d, weights + k);
    }
    ChannelSums channels;
    for (std::uint32_t k = 0; k < few.count; ++k) {
        if (weights[k] > 0) {
            channels.add(weights[k], texels.values + std::size_t{texels.stride} * k, reference);
        }
    }
    channels.moveTo(sums);
    sums.weight += static_cast<double>(hn::GetLane(hn::SumOfLanes(d, weight)));
}

} // namespace HWY_NAMESPACE
} // namespace trixel
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace trixel {

HWY_EXPORT(addUnderWindow);

void addUnderWindow(const LevelTexels& texels,
                    const std::array<HalfLattice, 2>& halves,
                    const GaussianWindow& window,
                    const GroupValue& reference,
                    WindowSums& sums)
{
    HWY_DYNAMIC_DISPATCH(addUnderWindow)(texels, halves, window, reference, sums);
}

HWY_EXPORT(addFewUnderWindow);

void addFewUnderWindow(const LevelTexels& texels,
                       const FewTexels& few,
                       const GaussianWindow& window,
                       const GroupValue& reference,
                       WindowSums& sums)
{
    HWY_DYNAMIC_DISPATCH(addFewUnderWindow)(texels, few, window, reference, sums);
}

} // namespace trixel
#endif
