// SPDX-License-Identifier: GPL-3.0-or-later
//
// What probes read beyond a face's own level: its texels. Vertex averages of the base blur by more
// than the narrowest footprints are wide; one level beyond them stands hexlin, the linear
// interpolation between vertex, middle of an edge and centroid of the texel:
//   f = (1 - 2 q - r) P + 3 r T + 2 (q - r) M,
// p >= q >= r the barycentrics within texel T, P and Q the vertices of p and q, M the middle of PQ:
// the mean of T and of T', its neighbour across PQ. On the edges of a face M is the mean of P and
// Q, so that f is what vertex averages give there and neighbours agree whatever their levels.
//
// Included once per instruction set (see Highway).
#include "core/filter/probe_reads_simd-inl.h"

#include <hwy/highway.h>

#if defined(TRIXEL_PROBE_TEXELS_SIMD) == defined(HWY_TARGET_TOGGLE)
#ifdef TRIXEL_PROBE_TEXELS_SIMD
#undef TRIXEL_PROBE_TEXELS_SIMD
#else
#define TRIXEL_PROBE_TEXELS_SIMD
#endif

HWY_BEFORE_NAMESPACE();
namespace trixel::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// The texels that points lie in, and those across one of their edges.
struct TexelLanes
{
    VI own; ///< packed index
    VI across;
    hn::Mask<DI> hasAcross; ///< in the same face
};

/// \param isFirst, isThird  whether the vertex opposite to the edge is that of the reads' pair, or
///                          single; else it is the pair's second
HWY_INLINE TexelLanes texelLanes(const LatticeLanes& at, hn::Mask<DI> isFirst, hn::Mask<DI> isThird)
{
    const DI di;
    const VI one = hn::Set(di, 1);
    const VI size = at.resolution;
    const VI lastTexel = hn::Sub(hn::Mul(size, size), one);
    const auto lower = [&](VI i, VI j) HWY_ATTR { return hn::Add(i, hn::Mul(j, size)); };
    const auto upper = [&](VI i, VI j)
                           HWY_ATTR { return hn::Sub(lastTexel, hn::Add(j, hn::Mul(i, size))); };
    const auto isUpper = hn::RebindMask(di, at.isUpper());
    const auto isSecond = hn::Not(hn::Or(isFirst, isThird));
    const VI back = hn::Sub(at.i, hn::IfThenElseZero(isSecond, one));
    const VI down = hn::Sub(at.j, hn::IfThenElseZero(isThird, one));
    const VI ahead = hn::Add(at.i, hn::IfThenElseZero(isFirst, one));
    const VI up = hn::Add(at.j, hn::IfThenElseZero(isThird, one));
    const auto isInside = hn::And(hn::Gt(hn::Min(back, down), hn::Set(di, -1)),
                                  hn::Lt(hn::Add(back, down), hn::Sub(size, one)));
    return {hn::IfThenElse(isUpper, upper(at.i, at.j), lower(at.i, at.j)),
            hn::IfThenElse(isUpper, lower(ahead, up), upper(back, down)),
            hn::Or(isUpper, isInside)};
}

/// Finds the texels that probes read, `end` - `begin` of one face, whose own level is coarser than
/// their finer one, and takes from the vertices what these get.
///
/// \param share     of a probe's weight that its finer level has
/// \param vertices  of the face's own level
/// \return          texels that are read
HWY_INLINE std::size_t findTexels(const PackedProbes& probes,
                                  float share,
                                  std::size_t begin,
                                  std::size_t end,
                                  LevelReads& vertices,
                                  TexelReads& texels)
{
    const DF d;
    const DI di;
    std::size_t count = 0;
    for (std::size_t k = begin; k < end; k += hn::Lanes(d)) {
        const auto valid = hn::FirstN(d, end - k);
        const VF first = hn::LoadU(d, vertices.first + k);
        const VF second = hn::LoadU(d, vertices.second + k);
        const VF third = hn::LoadU(d, vertices.third + k);
        const VF r = hn::Min(hn::Min(first, second), third);
        const VF q = hn::Max(hn::Min(first, second), hn::Min(hn::Max(first, second), third));
        const auto isThird = hn::Eq(third, r);
        const auto isSecond = hn::AndNot(isThird, hn::Eq(second, r));
        const auto isFirst = hn::Not(hn::Or(isThird, isSecond));
        const TexelLanes of = texelLanes(
            latticeLanes(probes, k), hn::RebindMask(di, isFirst), hn::RebindMask(di, isThird));
        const auto hasAcross = hn::RebindMask(d, of.hasAcross);

        const VF middle = hn::Mul(q, hn::Set(d, share));
        const VF least = hn::Mul(r, hn::Set(d, share));
        const VF twice = hn::Add(least, least);
        const VF ofMiddle = hn::IfThenElse(hasAcross, middle, least);
        hn::StoreU(of.own, di, texels.own + k);
        hn::StoreU(hn::IfThenElse(of.hasAcross, of.across, of.own), di, texels.other + k);
        hn::StoreU(hn::Add(ofMiddle, twice), d, texels.ownWeight + k);
        hn::StoreU(hn::Sub(ofMiddle, least), d, texels.otherWeight + k);
        const auto take = [&](VF from, hn::Mask<DF> isLeast, float* to) HWY_ATTR {
            const VF left = hn::Sub(from, hn::IfThenElse(isLeast, least, ofMiddle));
            hn::BlendedStore(left, valid, d, to + k);
        };
        take(first, isFirst, vertices.first);
        take(second, isSecond, vertices.second);
        take(third, isThird, vertices.third);
        count += hn::CountTrue(d, valid) + hn::CountTrue(d, hn::And(valid, hasAcross));
    }
    return count;
}

} // namespace trixel::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
