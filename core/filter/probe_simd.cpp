// SPDX-License-Identifier: GPL-3.0-or-later
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/filter/probe_simd.cpp"
// clang-format off
#include <hwy/foreach_target.h> // before all others
// clang-format on

#include "core/filter/probe_simd.h"

#include "core/filter/probe_lanes_simd-inl.h"
#include "core/filter/probe_plan_simd-inl.h"
#include "core/filter/probe_sum_simd-inl.h"
#include "core/filter/query_filter.h"
#include "core/filter/texel_detail.h"

#include <cmath>
#include <hwy/cache_control.h>

HWY_BEFORE_NAMESPACE();
namespace trixel::HWY_NAMESPACE {

/// What the probes of one line read.
struct LineReads
{
    Reads fine, coarse;
    TexelReads texels;
    float weight = 0; ///< of all probes
};

/// The lines of one query.
struct QueryLines
{
    std::size_t first = 0, count = 0;
    float coarse = 0; ///< weight of the coarser level
    int fine = 0;     ///< number of the finer level
};

/// Queries whose reads are asked for together.
constexpr std::size_t kReadTogether = 4;

/// Room for one block of queries.
struct Workspace
{
    PlanInputs inputs;
    ProbePlans plans;
    QueryLines queries[ProbePlans::kSize];
    ProbeLine lines[WalkLines::kSize];
    ProbeRange ranges[WalkLines::kSize]; ///< of the lines
    WalkLines walked;
    std::size_t lineOf[WalkLines::kSize]; ///< that is walked
    SideLanes sides;
    Pieces pieces;
    ProbeArrays probes;
    LineReads reads[kReadTogether * kMostLines];
};

void gatherInputs(const FilterScene& scene,
                  const FilterQueries& queries,
                  std::size_t begin,
                  std::size_t count,
                  PlanInputs& in)
{
    for (std::size_t k = 0; k < count; ++k) {
        const std::size_t q = begin + k;
        const FaceId face = queries.face[q];
        in.u[k] = double{queries.u[q]};
        in.v[k] = double{queries.v[q]};
        in.w1u[k] = double{queries.uw1[q]};
        in.w1v[k] = double{queries.vw1[q]};
        in.w2u[k] = double{queries.uw2[q]};
        in.w2v[k] = double{queries.vw2[q]};
        const FaceShape& shape = scene.surface().shape(face);
        in.e1x[k] = shape.e1.x;
        in.e2x[k] = shape.e2.x;
        in.e2y[k] = shape.e2.y;
        for (int corner = 0; corner < 3; ++corner) {
            in.texel[corner][k] = scene.log2TexelSize(face, corner);
            in.edge[corner][k] = scene.surface().log2Length(face, corner);
        }
    }
}

/// Where a probe finds a group of channels.
HWY_INLINE const float*
valuesOf(const FilterScene& scene, const Workspace& work, int fine, std::size_t probe, int group)
{
    if (group == 0) {
        return work.probes.values[probe];
    }
    const FaceId face = work.probes.face[probe];
    return scene.pyramid().vertices(face, std::min(Level(fine), scene.level(face)), group).values;
}

/// Adds the texels that the probes of a line read.
HWY_INLINE void addTexels(const FilterScene& scene,
                          const Workspace& work,
                          const ProbeRange& range,
                          const TexelReads& texels,
                          int group,
                          ChannelSum& sum)
{
    for (std::size_t k = 0; k < range.count; ++k) {
        if (texels.ownWeight[k] > 0 || texels.otherWeight[k] > 0) {
            const FaceId face = work.probes.face[range.first + k];
            const LevelTexels base = scene.mips().texels(face, scene.level(face), group);
            sum.add(base.texel(TexelIndex{texels.own[k]}), texels.ownWeight[k]);
            sum.add(base.texel(TexelIndex{texels.other[k]}), texels.otherWeight[k]);
        }
    }
}

/// Sums the probes of one query for one group of channels.
/// \param reads  of the query's lines
HWY_INLINE void sumProbes(const FilterScene& scene,
                          const Workspace& work,
                          const QueryLines& query,
                          const LineReads* reads,
                          int group,
                          float* value)
{
    const std::size_t some = work.ranges[query.first].first;
    const float* origin = valuesOf(scene, work, query.fine, some, group) + reads[0].fine.pair[0];
    ChannelSum sum(origin);
    for (std::size_t l = 0; l < query.count; ++l) {
        const ProbeRange& range = work.ranges[query.first + l];
        ChannelSum fine(origin);
        ChannelSum coarse(origin);
        for (std::size_t k = 0; k < range.count; ++k) {
            const float* values = valuesOf(scene, work, query.fine, range.first + k, group);
            fine.add(values, reads[l].fine, k);
            if (query.coarse > 0) {
                coarse.add(values, reads[l].coarse, k);
            }
        }
        if (reads[l].texels.count > 0) {
            addTexels(scene, work, range, reads[l].texels, group, fine);
        }
        const auto share = static_cast<float>(work.lines[query.first + l].share);
        sum.addSums(fine, coarse, share / reads[l].weight);
    }
    sum.store(value);
}

/// Finds out what a line reads, and asks the caches for it.
HWY_INLINE void
prepareLine(Workspace& work, std::size_t line, double falloff, float coarse, LineReads& reads)
{
    const ProbeRange& range = work.ranges[line];
    const double support = work.lines[line].support;
    Reads& fine = reads.fine;
    reads.weight = findReads(work.probes, range, support, falloff, coarse, fine, reads.coarse);
    findTexels(work.probes, range, coarse, {fine.first, fine.second, fine.third}, reads.texels);
    for (std::size_t p = 0; p < range.count; ++p) {
        const float* values = work.probes.values[range.first + p];
        hwy::Prefetch(values + reads.fine.pair[p]);
        hwy::Prefetch(values + reads.fine.single[p]);
        if (coarse > 0) {
            hwy::Prefetch(values + reads.coarse.pair[p]);
            hwy::Prefetch(values + reads.coarse.single[p]);
        }
    }
}

void finishQuery(const FilterScene& scene,
                 const FilterQueries& queries,
                 std::size_t q,
                 const Workspace& work,
                 const QueryLines& query,
                 const LineReads* reads,
                 const FilterResults& results)
{
    const FaceId face = queries.face[q];
    const bool hasCentre = std::isfinite(queries.u[q]) && std::isfinite(queries.v[q]);
    for (int group = 0; group < scene.mips().groups(); ++group) {
        GroupValue value;
        if (hasCentre) {
            sumProbes(scene, work, query, reads, group, value.data());
        } else {
            std::copy_n(scene.mips().average(face, group), kGroupChannels, value.begin());
        }
        storeAnswer(results, q, group, scene.channels(), value);
    }
    const int level = std::min(query.fine, scene.level(face).log2());
    std::size_t taps = 0;
    for (std::size_t l = 0; l < query.count; ++l) {
        taps +=
            work.ranges[query.first + l].count * (query.coarse > 0 ? 6 : 3) + reads[l].texels.count;
    }
    storeCost(results,
              q,
              hasCentre ? QueryCost{static_cast<float>(level), static_cast<std::uint32_t>(taps)}
                        : QueryCost{0, 1});
}

/// Tells where the probes of the pieces are.
void fillPieces(const FilterScene& scene, Workspace& work)
{
    const hn::ScalableTag<double> d;
    const hn::Rebind<std::int64_t, decltype(d)> di;
    const hn::Rebind<std::int32_t, decltype(d)> dn;
    const Pieces& pieces = work.pieces;
    ProbeArrays& to = work.probes;
    for (std::size_t k = 0; k < pieces.count; ++k) {
        const auto face = faceId(static_cast<std::size_t>(pieces.face[k]));
        const auto id = static_cast<std::size_t>(pieces.id[k]);
        const ProbeRange& range = work.ranges[work.lineOf[id >> 16 & 0xFFFF]];
        const ConformingPyramid::Finest finest = scene.pyramid().finest(face, Level(range.fine));
        std::size_t at = (id & 0xFFFF) + static_cast<std::size_t>(pieces.begin[k]);
        const auto count = static_cast<std::size_t>(pieces.end[k] - pieces.begin[k]);
        const auto perU = hn::Set(d, pieces.perU[k]);
        const auto perV = hn::Set(d, pieces.perV[k]);
        const auto scale = hn::Set(d, double(finest.level.resolution()));
        const auto values = hn::Set(di, reinterpret_cast<std::int64_t>(finest.values));
        const auto stride = hn::Set(dn, static_cast<std::int32_t>(finest.stride));
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
            for (std::size_t p = at; p < at + some; ++p) {
                to.face[p] = face;
            }
            step = hn::Add(step, hn::Set(d, double(hn::Lanes(d))));
            at += some;
            left -= some;
        }
    }
}

/// Places and shares of the probes of a line that no border cuts, for whole registers.
void layPlaces(std::size_t first, int perSide, ProbeArrays& probes)
{
    for (int way = 0; way < 2; ++way) {
        for (int k = 0; k < perSide; ++k, ++first) {
            probes.place[first] = static_cast<float>(k) + 0.5F;
            probes.share[first] = 1;
        }
    }
}

/// Places the probes of as many queries of a block as there is room for; returns how many.
std::size_t placeSome(const FilterScene& scene,
                      const FilterQueries& queries,
                      std::size_t begin,
                      std::size_t first,
                      std::size_t end,
                      Workspace& work)
{
    constexpr std::size_t kMostPerLine = kRoomPerLine + HWY_MAX_BYTES / sizeof(double);
    const std::size_t lanes = hn::Lanes(hn::ScalableTag<double>());
    std::size_t lines = 0;
    std::size_t probes = 0;
    std::size_t count = 0;
    work.walked.count = 0;
    for (; first + count < end && lines + kMostLines <= WalkLines::kSize &&
           probes + kMostLines * kMostPerLine <= ProbeArrays::kSize;
         ++count) {
        const std::size_t plan = first + count;
        QueryLines& query = work.queries[count];
        query.first = lines;
        query.count = linesOf(work.plans, plan, queries.face[begin + plan], work.lines + lines);
        query.coarse = static_cast<float>(work.plans.coarse[plan]);
        query.fine = static_cast<int>(work.plans.fine[plan]);
        for (std::size_t l = 0; l < query.count; ++l, ++lines) {
            const ProbeLine& line = work.lines[lines];
            ProbeRange& range = work.ranges[lines];
            range = {probes, 0, query.fine};
            if (line.hasDirection()) {
                const int perSide = line.perSide();
                range.count = 2 * static_cast<std::size_t>(perSide);
                layPlaces(probes, perSide, work.probes);
                work.lineOf[work.walked.count] = lines;
                work.walked.add(line, perSide, probes);
            } else {
                range.count = placeProbes(scene, line, query.fine, probes, work.probes);
            }
            probes += (range.count + lanes - 1) / lanes * lanes;
        }
    }
    LineWalker(scene.surface(), work.walked, work.sides, work.pieces).walk();
    fillPieces(scene, work);
    for (std::size_t k = 0; k < work.walked.count; ++k) {
        if (work.walked.isCut[k]) {
            const std::size_t line = work.lineOf[k];
            ProbeRange& range = work.ranges[line];
            range.count =
                placeProbes(scene, work.lines[line], range.fine, range.first, work.probes);
        }
    }
    return count;
}

/// Answers queries whose probes are placed.
void finishSome(const FilterScene& scene,
                const FilterQueries& queries,
                std::size_t begin,
                std::size_t count,
                double falloff,
                const FilterResults& results,
                Workspace& work)
{
    for (std::size_t first = 0; first < count; first += kReadTogether) {
        const std::size_t some = std::min(kReadTogether, count - first);
        for (std::size_t k = 0; k < some; ++k) {
            const QueryLines& query = work.queries[first + k];
            for (std::size_t l = 0; l < query.count; ++l) {
                prepareLine(
                    work, query.first + l, falloff, query.coarse, work.reads[k * kMostLines + l]);
            }
        }
        for (std::size_t k = 0; k < some; ++k) {
            finishQuery(scene,
                        queries,
                        begin + first + k,
                        work,
                        work.queries[first + k],
                        work.reads + k * kMostLines,
                        results);
        }
    }
}

void filterBlock(const FilterScene& scene,
                 const FilterQueries& queries,
                 const ProbeSettings& settings,
                 const FilterResults& results)
{
    HWY_ALIGN static thread_local Workspace work;
    for (std::size_t begin = 0; begin < queries.size(); begin += ProbePlans::kSize) {
        const std::size_t count = std::min(ProbePlans::kSize, queries.size() - begin);
        gatherInputs(scene, queries, begin, count, work.inputs);
        planAll(work.inputs, count, settings, work.plans);
        for (std::size_t done = 0; done < count;) {
            const std::size_t some = placeSome(scene, queries, begin, done, count, work);
            finishSome(scene, queries, begin + done, some, settings.falloff, results, work);
            done += some;
        }
    }
}

} // namespace trixel::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace trixel {

HWY_EXPORT(filterBlock);

void filterByProbes(const FilterScene& scene,
                    const FilterQueries& queries,
                    const ProbeSettings& settings,
                    const FilterResults& results)
{
    checkRoom(scene, queries, results);
    HWY_DYNAMIC_DISPATCH(filterBlock)(scene, queries, settings, results);
}

std::vector<std::int64_t> probeTargets()
{
    return hwy::SupportedAndGeneratedTargets();
}

void filterByProbesOn(std::int64_t target,
                      const FilterScene& scene,
                      const FilterQueries& queries,
                      const ProbeSettings& settings,
                      const FilterResults& results)
{
    hwy::SetSupportedTargetsForTest(target);
    hwy::GetChosenTarget().Update(target);
    filterByProbes(scene, queries, settings, results);
    hwy::SetSupportedTargetsForTest(0);
    hwy::GetChosenTarget().DeInit();
}

} // namespace trixel
#endif
