// SPDX-License-Identifier: GPL-3.0-or-later
//
// Plans → probes: which lines queries have, and where the probes of these lie. Included once per
// instruction set (see Highway).
#include "core/filter/probe_lanes_simd-inl.h"
#include "core/filter/probe_walk.h"

#include <hwy/highway.h>
#include <span>

#if defined(TRIXEL_PROBE_PLACE_SIMD) == defined(HWY_TARGET_TOGGLE)
#ifdef TRIXEL_PROBE_PLACE_SIMD
#undef TRIXEL_PROBE_PLACE_SIMD
#else
#define TRIXEL_PROBE_PLACE_SIMD
#endif

HWY_BEFORE_NAMESPACE();
namespace trixel::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// The lines of one query.
struct QueryLines
{
    std::size_t first = 0, count = 0;
    std::size_t texels = 0; ///< that they read
};

/// Queries on their way from plans to answers, a batch at a time.
struct ProbeBatch
{
    QueryLines queries[ProbePlans::kSize];
    ProbeLine lines[WalkLines::kSize];
    ProbeRange ranges[WalkLines::kSize]; ///< of the lines
    WalkLines walked;
    std::size_t lineOf[WalkLines::kSize]; ///< that is walked
    SideLanes sides;
    Pieces pieces;
    ProbeArrays probes;
};

/// Tells where the probes of the pieces are.
void fillPieces(const FilterScene& scene, ProbeBatch& batch)
{
    const hn::ScalableTag<double> d;
    const hn::Rebind<std::int64_t, decltype(d)> di;
    const hn::Rebind<std::int32_t, decltype(d)> dn;
    const hn::Rebind<float, decltype(d)> df;
    const Pieces& pieces = batch.pieces;
    ProbeArrays& to = batch.probes;
    for (std::size_t k = 0; k < pieces.count; ++k) {
        const auto face = faceId(static_cast<std::size_t>(pieces.face[k]));
        const auto id = static_cast<std::size_t>(pieces.id[k]);
        ProbeRange& range = batch.ranges[batch.lineOf[id >> 16 & 0xFFFF]];
        const Level fine(range.fine);
        const ConformingPyramid::Finest finest = scene.pyramid().finest(face, fine);
        range.beyond |= finest.level < fine;
        std::size_t at = (id & 0xFFFF) + static_cast<std::size_t>(pieces.begin[k]);
        const auto count = static_cast<std::size_t>(pieces.end[k] - pieces.begin[k]);
        const auto perU = hn::Set(d, pieces.perU[k]);
        const auto perV = hn::Set(d, pieces.perV[k]);
        const auto scale = hn::Set(d, double(finest.level.resolution()));
        const auto values = hn::Set(di, reinterpret_cast<std::int64_t>(finest.values));
        const auto stride = hn::Set(dn, static_cast<std::int32_t>(finest.stride));
        const auto coarse = hn::Set(df, finest.level < fine ? 0.0F : range.coarse);
        auto step = hn::Iota(d, 0);
        for (std::size_t left = count; left > 0;) {
            const std::size_t some = std::min(left, hn::Lanes(d));
            const auto mask = hn::FirstN(d, some);
            const auto u = hn::MulAdd(step, perU, hn::Set(d, pieces.u[k]));
            const auto v = hn::MulAdd(step, perV, hn::Set(d, pieces.v[k]));
            hn::BlendedStore(u, mask, d, to.u + at);
            hn::BlendedStore(v, mask, d, to.v + at);
            hn::BlendedStore(scale, mask, d, to.scale + at);
            hn::BlendedStore(values,
                             hn::RebindMask(di, mask),
                             di,
                             reinterpret_cast<std::int64_t*>(to.values + at));
            hn::BlendedStore(stride, hn::FirstN(dn, some), dn, to.stride + at);
            hn::BlendedStore(coarse, hn::FirstN(df, some), df, to.coarse + at);
            for (std::size_t p = at; p < at + some; ++p) {
                to.face[p] = face;
            }
            step = hn::Add(step, hn::Set(d, double(hn::Lanes(d))));
            at += some;
            left -= some;
        }
    }
}

/// Places and shares of the probes of a line that no border cuts.
void layPlaces(const ProbeLine& line, int perSide, std::size_t first, ProbeArrays& probes)
{
    const auto perSupport = static_cast<float>(1 / line.support);
    for (int way = 0; way < 2; ++way) {
        for (int k = 0; k < perSide; ++k, ++first) {
            probes.place[first] = (static_cast<float>(k) + 0.5F) * perSupport;
            probes.share[first] = 1;
        }
    }
}

/// Places the probes of as many queries of a block as there is room for, from `first` on; returns
/// how many.
/// \param faces  of the block's queries
std::size_t placeSome(const FilterScene& scene,
                      const ProbePlans& plans,
                      std::span<const FaceId> faces,
                      std::size_t first,
                      ProbeBatch& batch)
{
    std::size_t lines = 0;
    std::size_t probes = 0;
    std::size_t count = 0;
    batch.walked.count = 0;
    for (; first + count < faces.size() && lines + kMostLines <= WalkLines::kSize &&
           probes + kMostLines * kRoomPerLine <= ProbeArrays::kSize;
         ++count) {
        const std::size_t plan = first + count;
        QueryLines& query = batch.queries[count];
        query.first = lines;
        query.count = linesOf(plans, plan, faces[plan], batch.lines + lines);
        const auto coarse = static_cast<float>(plans.coarse[plan]);
        const int fine = static_cast<int>(plans.fine[plan]);
        for (std::size_t l = 0; l < query.count; ++l, ++lines) {
            const ProbeLine& line = batch.lines[lines];
            ProbeRange& range = batch.ranges[lines];
            range = {probes, 0, fine, coarse, false};
            if (line.hasDirection()) {
                const int perSide = line.perSide();
                range.count = 2 * static_cast<std::size_t>(perSide);
                layPlaces(line, perSide, probes, batch.probes);
                batch.lineOf[batch.walked.count] = lines;
                batch.walked.add(line, perSide, probes);
            } else {
                placeProbes(scene, line, range, batch.probes);
            }
            probes += range.count;
        }
    }
    LineWalker(scene.surface(), batch.walked, batch.sides, batch.pieces).walk();
    fillPieces(scene, batch);
    for (std::size_t k = 0; k < batch.walked.count; ++k) {
        if (batch.walked.isCut[k]) {
            const std::size_t line = batch.lineOf[k];
            placeProbes(scene, batch.lines[line], batch.ranges[line], batch.probes);
        }
    }
    return count;
}

} // namespace trixel::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
