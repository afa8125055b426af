// SPDX-License-Identifier: GPL-3.0-or-later
//
// Probes → the vertices that they read and how much these count, several at a time. Included once
// per instruction set (see Highway).
#include "core/filter/probe_reads.h"
#include "core/texture/conforming_pyramid.h"

#include <hwy/highway.h>

#if defined(TRIXEL_PROBE_READS_SIMD) == defined(HWY_TARGET_TOGGLE)
#ifdef TRIXEL_PROBE_READS_SIMD
#undef TRIXEL_PROBE_READS_SIMD
#else
#define TRIXEL_PROBE_READS_SIMD
#endif

HWY_BEFORE_NAMESPACE();
namespace trixel::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using DD = hn::ScalableTag<double>;
using DF = hn::Rebind<float, DD>;
using DI = hn::Rebind<std::int32_t, DD>;
using VF = hn::Vec<DF>;
using VI = hn::Vec<DI>;

/// Places on lattices: cell and fraction.
struct LatticeLanes
{
    VI i, j;
    VF x, y;
    VI resolution;

    /// Whether they lie in the upper texel of the cell. On the hypotenuse there is none, whatever
    /// rounding makes of it.
    HWY_INLINE hn::Mask<DF> isUpper() const
    {
        const DI di;
        const auto isInner = hn::Lt(hn::Add(i, j), hn::Sub(resolution, hn::Set(di, 1)));
        const auto isAbove = hn::Gt(hn::Add(x, y), hn::Set(DF(), 1.0F));
        return hn::And(isAbove, hn::RebindMask(DF(), isInner));
    }
};

/// Where probes lie, from the one at k on.
HWY_INLINE LatticeLanes latticeLanes(const PackedProbes& probes, std::size_t k)
{
    const DD dd;
    const DF d;
    const DI di;
    const auto u = hn::LoadU(dd, probes.u + k);
    const auto v = hn::LoadU(dd, probes.v + k);
    LatticeLanes at;
    at.resolution = hn::LoadU(di, probes.resolution + k);
    const VI none = hn::Zero(di);
    const VI last = hn::Sub(at.resolution, hn::Set(di, 1));
    at.i = hn::Min(hn::Max(hn::DemoteTo(di, u), none), last);
    at.j = hn::Min(hn::Max(hn::DemoteTo(di, v), none), hn::Sub(last, at.i));
    const auto inCell = [&](auto place, VI cell) HWY_ATTR {
        const VF fraction = hn::DemoteTo(d, hn::Sub(place, hn::PromoteTo(dd, cell)));
        return hn::Min(hn::Max(fraction, hn::Zero(d)), hn::Set(d, 1.0F));
    };
    at.x = inCell(u, at.i);
    at.y = inCell(v, at.j);
    return at;
}

/// The same at the level below.
HWY_INLINE LatticeLanes parentLanes(const LatticeLanes& at)
{
    const DF d;
    const VI odd = hn::Set(DI(), 1);
    const VF half = hn::Set(d, 0.5F);
    LatticeLanes parent;
    parent.x = hn::Mul(half, hn::Add(at.x, hn::ConvertTo(d, hn::And(at.i, odd))));
    parent.y = hn::Mul(half, hn::Add(at.y, hn::ConvertTo(d, hn::And(at.j, odd))));
    parent.i = hn::ShiftRight<1>(at.i);
    parent.j = hn::ShiftRight<1>(at.j);
    parent.resolution = hn::ShiftRight<1>(at.resolution);
    return parent;
}

/// \param below  vertices from the level to the probe's `values`
HWY_INLINE void
storeReads(const LatticeLanes& at, VI below, VF weight, std::size_t k, LevelReads& reads)
{
    const DF d;
    const DI di;
    const VF one = hn::Set(d, 1.0F);
    const VF sum = hn::Add(at.x, at.y);
    const auto isUpper = at.isUpper();
    const auto upper = hn::RebindMask(di, isUpper);

    // Row j begins at j (2R + 3 - j) / 2 and the next R + 1 - j later.
    const VI rows = hn::Sub(hn::Add(hn::Add(at.resolution, at.resolution), hn::Set(di, 3)), at.j);
    const VI low = hn::Add(hn::ShiftRight<1>(hn::Mul(at.j, rows)), hn::Sub(at.i, below));
    const VI high = hn::Add(low, hn::Sub(hn::Add(at.resolution, hn::Set(di, 1)), at.j));
    const VI pair = hn::IfThenElse(upper, high, low);
    const VI single = hn::IfThenElse(upper, hn::Add(low, hn::Set(di, 1)), high);
    static_assert(kGroupChannels == 4);
    hn::Store(hn::ShiftLeft<2>(pair), di, reads.pair + k);
    hn::Store(hn::ShiftLeft<2>(single), di, reads.single + k);

    const VF rest = hn::Sub(one, sum);
    const VF first = hn::IfThenElse(isUpper, hn::Sub(one, at.x), hn::Max(rest, hn::Zero(d)));
    const VF second = hn::IfThenElse(isUpper, hn::Neg(rest), at.x);
    const VF third = hn::IfThenElse(isUpper, hn::Sub(one, at.y), at.y);
    hn::Store(hn::Mul(weight, first), d, reads.first + k);
    hn::Store(hn::Mul(weight, second), d, reads.second + k);
    hn::Store(hn::Mul(weight, third), d, reads.third + k);
}

/// Finds what `count` probes read at their level and at the one below. Level 0 has none: nothing
/// that is found there may be read.
HWY_INLINE void
findReads(const PackedProbes& probes, std::size_t count, LevelReads& fine, LevelReads& coarse)
{
    const DF d;
    const DI di;
    for (std::size_t k = 0; k < count; k += hn::Lanes(d)) {
        const VF weight = hn::Load(d, probes.weight + k);
        const LatticeLanes at = latticeLanes(probes, k);
        storeReads(at, hn::Zero(di), weight, k, fine);
        // All vertices of the coarser level come before those of the finer one.
        const LatticeLanes parent = parentLanes(at);
        const VI next = hn::Add(parent.resolution, hn::Set(di, 1));
        const VI below = hn::ShiftRight<1>(hn::Mul(next, hn::Add(next, hn::Set(di, 1))));
        storeReads(parent, below, weight, k, coarse);
    }
}

} // namespace trixel::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
