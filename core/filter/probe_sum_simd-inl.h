// SPDX-License-Identifier: GPL-3.0-or-later
//
// Probes → the answer: where each reads and how much it counts, several at a time, then four
// channels at a time the sum. Included once per instruction set (see Highway).
#include "core/filter/probe_plan.h"
#include "core/filter/probe_walk.h"
#include "core/filter/texel_detail.h"

#include <hwy/contrib/math/math-inl.h>
#include <hwy/highway.h>

#if defined(TRIXEL_PROBE_SUM_SIMD) == defined(HWY_TARGET_TOGGLE)
#ifdef TRIXEL_PROBE_SUM_SIMD
#undef TRIXEL_PROBE_SUM_SIMD
#else
#define TRIXEL_PROBE_SUM_SIMD
#endif

HWY_BEFORE_NAMESPACE();
namespace trixel::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// The three vertices that each probe reads at a level: two beside each other in a row of the
/// lattice and one in the row above or below.
struct LevelReads
{
    static constexpr std::size_t kRoom = TexelReads::kRoom;

    alignas(64) std::int32_t pair[kRoom]; ///< floats from the probe's values
    alignas(64) std::int32_t single[kRoom];
    alignas(64) float first[kRoom]; ///< weights of the pair's first and second
    alignas(64) float second[kRoom];
    alignas(64) float third[kRoom];
};

/// What consecutive probes of some lines read.
struct Reads
{
    std::size_t begin = 0, end = 0; ///< places of these probes
    LevelReads fine, coarse;
    alignas(64) float weight[LevelReads::kRoom];
    TexelReads texels; ///< of lines that have some
};

using DD = hn::ScalableTag<double>;
using DF = hn::Rebind<float, DD>;
using DI = hn::Rebind<std::int32_t, DD>;
using VF = hn::Vec<DF>;
using VI = hn::Vec<DI>;

/// Place on a lattice: cell and fraction.
struct LatticeLanes
{
    VI i, j;
    VF x, y;
    VI resolution;
};

/// \param below  vertices from the level to the probe's `values`
HWY_INLINE void
storeReads(const LatticeLanes& at, VI below, VI stride, VF weight, std::size_t k, LevelReads& reads)
{
    const DF d;
    const DI di;
    const VF one = hn::Set(d, 1.0F);
    const VF sum = hn::Add(at.x, at.y);
    // On the hypotenuse there is no upper texel, whatever rounding makes of it.
    const auto isInner = hn::Lt(hn::Add(at.i, at.j), hn::Sub(at.resolution, hn::Set(di, 1)));
    const auto isUpper = hn::And(hn::Gt(sum, one), hn::RebindMask(d, isInner));
    const auto upper = hn::RebindMask(di, isUpper);

    // Row j begins at j (2R + 3 - j) / 2 and the next R + 1 - j later.
    const VI rows = hn::Sub(hn::Add(hn::Add(at.resolution, at.resolution), hn::Set(di, 3)), at.j);
    const VI low = hn::Add(hn::ShiftRight<1>(hn::Mul(at.j, rows)), hn::Sub(at.i, below));
    const VI high = hn::Add(low, hn::Sub(hn::Add(at.resolution, hn::Set(di, 1)), at.j));
    const VI pair = hn::IfThenElse(upper, high, low);
    const VI single = hn::IfThenElse(upper, hn::Add(low, hn::Set(di, 1)), high);
    hn::Store(hn::Mul(pair, stride), di, reads.pair + k);
    hn::Store(hn::Mul(single, stride), di, reads.single + k);

    const VF rest = hn::Sub(one, sum);
    const VF first = hn::IfThenElse(isUpper, hn::Sub(one, at.x), hn::Max(rest, hn::Zero(d)));
    const VF second = hn::IfThenElse(isUpper, hn::Neg(rest), at.x);
    const VF third = hn::IfThenElse(isUpper, hn::Sub(one, at.y), at.y);
    hn::Store(hn::Mul(weight, first), d, reads.first + k);
    hn::Store(hn::Mul(weight, second), d, reads.second + k);
    hn::Store(hn::Mul(weight, third), d, reads.third + k);
}

/// Fills weights and reads at both levels.
///
/// \param c  falloff of the weights, see `ProbeLine`
HWY_INLINE void findReads(const ProbeArrays& probes, double c, Reads& reads)
{
    const DD dd;
    const DF d;
    const DI di;
    const VF falloff = hn::Set(d, static_cast<float>(-c));
    const VF pedestal = hn::Set(d, static_cast<float>(std::exp(-c)));
    for (std::size_t p = reads.begin; p < reads.end; p += hn::Lanes(dd)) {
        const std::size_t k = p - reads.begin;
        const VF x = hn::LoadU(d, probes.place + p);
        const VF bell = hn::Sub(hn::Exp(d, hn::Mul(falloff, hn::Mul(x, x))), pedestal);
        // Never nothing: at a border one probe may be all there is.
        const VF weight = hn::Mul(hn::Max(bell, hn::Set(d, 1e-6F)), hn::LoadU(d, probes.share + p));
        hn::Store(weight, d, reads.weight + k);

        const auto scale = hn::LoadU(dd, probes.scale + p);
        const auto u = hn::Mul(hn::LoadU(dd, probes.u + p), scale);
        const auto v = hn::Mul(hn::LoadU(dd, probes.v + p), scale);
        LatticeLanes at;
        at.resolution = hn::DemoteTo(di, scale);
        const VI last = hn::Sub(at.resolution, hn::Set(di, 1));
        const VI none = hn::Zero(di);
        at.i = hn::Min(hn::Max(hn::DemoteTo(di, u), none), last);
        at.j = hn::Min(hn::Max(hn::DemoteTo(di, v), none), hn::Sub(last, at.i));
        const auto inCell = [&](auto place, VI cell) HWY_ATTR {
            const VF fraction = hn::DemoteTo(d, hn::Sub(place, hn::PromoteTo(dd, cell)));
            return hn::Min(hn::Max(fraction, hn::Zero(d)), hn::Set(d, 1.0F));
        };
        at.x = inCell(u, at.i);
        at.y = inCell(v, at.j);
        const VI stride = hn::LoadU(di, probes.stride + p);
        const VF share = hn::LoadU(d, probes.coarse + p);
        storeReads(at, none, stride, hn::NegMulAdd(weight, share, weight), k, reads.fine);
        const auto isBlended = hn::Gt(share, hn::Zero(d));
        if (!hn::AllFalse(d, isBlended)) {
            const VI odd = hn::Set(di, 1);
            const VF half = hn::Set(d, 0.5F);
            LatticeLanes parent;
            parent.x = hn::Mul(half, hn::Add(at.x, hn::ConvertTo(d, hn::And(at.i, odd))));
            parent.y = hn::Mul(half, hn::Add(at.y, hn::ConvertTo(d, hn::And(at.j, odd))));
            parent.i = hn::ShiftRight<1>(at.i);
            parent.j = hn::ShiftRight<1>(at.j);
            parent.resolution = hn::ShiftRight<1>(at.resolution);
            // All vertices of the coarser level come before those of the finer one.
            const VI next = hn::Add(parent.resolution, odd);
            const VI below = hn::ShiftRight<1>(hn::Mul(next, hn::Add(next, odd)));
            const VI blended = hn::IfThenElseZero(hn::RebindMask(di, isBlended), stride);
            storeReads(parent, below, blended, hn::Mul(weight, share), k, reads.coarse);
        }
    }
}

/// Four channels: one register, or four where registers hold one value. Sums differences from one
/// of the values that are averaged, so that a constant comes out to the bit.
class ChannelSum
{
public:
    /// \param origin  four channels of a value that is averaged
    explicit HWY_INLINE ChannelSum(const float* origin)
    {
        const D4 d;
        for (std::size_t p = 0; p < kParts; ++p) {
            m_origin[p] = hn::LoadU(d, origin + p * hn::Lanes(d));
            m_sum[p] = hn::Zero(d);
        }
    }

    HWY_INLINE void add(const float* values, const LevelReads& reads, std::size_t k)
    {
        const D4 d;
        const float* pair = values + reads.pair[k];
        const float* single = values + reads.single[k];
        const V4 first = hn::Set(d, reads.first[k]);
        const V4 second = hn::Set(d, reads.second[k]);
        const V4 third = hn::Set(d, reads.third[k]);
        for (std::size_t p = 0; p < kParts; ++p) {
            const std::size_t c = p * hn::Lanes(d);
            const auto off = [&](const float* value)
                                 HWY_ATTR { return hn::Sub(hn::LoadU(d, value + c), m_origin[p]); };
            V4 sum = hn::MulAdd(first, off(pair), m_sum[p]);
            sum = hn::MulAdd(second, off(pair + kGroupChannels), sum);
            m_sum[p] = hn::MulAdd(third, off(single), sum);
        }
    }

    /// Adds one value.
    HWY_INLINE void add(const float* value, float weight)
    {
        const D4 d;
        for (std::size_t p = 0; p < kParts; ++p) {
            const V4 off = hn::Sub(hn::LoadU(d, value + p * hn::Lanes(d)), m_origin[p]);
            m_sum[p] = hn::MulAdd(hn::Set(d, weight), off, m_sum[p]);
        }
    }

    /// Adds the sums of one line, of the same origin.
    HWY_INLINE void addSums(const ChannelSum& fine, const ChannelSum& coarse, float weight)
    {
        const D4 d;
        for (std::size_t p = 0; p < kParts; ++p) {
            const V4 sum = hn::Add(fine.m_sum[p], coarse.m_sum[p]);
            m_sum[p] = hn::MulAdd(hn::Set(d, weight), sum, m_sum[p]);
        }
    }

    /// origin + sum
    HWY_INLINE void store(float* value) const
    {
        const D4 d;
        for (std::size_t p = 0; p < kParts; ++p) {
            const V4 mean = hn::Add(m_sum[p], m_origin[p]);
            hn::StoreU(mean, d, value + p * hn::Lanes(d));
        }
    }

private:
    using D4 = hn::CappedTag<float, kGroupChannels>;
    using V4 = hn::Vec<D4>;
    static constexpr std::size_t kParts = HWY_TARGET == HWY_SCALAR ? kGroupChannels : 1;

    V4 m_origin[kParts];
    V4 m_sum[kParts];
};

} // namespace trixel::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
