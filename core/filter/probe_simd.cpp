// SPDX-License-Identifier: GPL-3.0-or-later
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/filter/probe_simd.cpp"
// clang-format off
#include <hwy/foreach_target.h> // before all others
// clang-format on

#include "core/filter/probe_simd.h"

#include "core/filter/probe_plan_simd-inl.h"
#include "core/filter/probe_sum_simd-inl.h"
#include "core/filter/query_filter.h"
#include "core/filter/texel_detail.h"

#include <cmath>
#include <hwy/cache_control.h>

HWY_BEFORE_NAMESPACE();
namespace trixel::HWY_NAMESPACE {

/// The probes of one line and what they read.
struct LineWork
{
    ProbeList list;
    Reads fine, coarse;
    TexelReads texels;
    float weight = 0; ///< of all probes, that of the line aside
};

/// The lines of one query.
struct QueryWork
{
    std::size_t first = 0, count = 0; ///< lines
    float coarseShare = 0;            ///< of the coarser level
    int fineLevel = 0;
};

/// Room for one block of queries and for those of them at work.
struct Workspace
{
    PlanInputs inputs;
    ProbePlans plans;
    ProbeLine lines[kWalkedTogether];
    LineWork works[kWalkedTogether];
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

/// Where the probes of a line find a group of channels.
HWY_INLINE const float*
valuesOf(const FilterScene& scene, const ProbeList& list, std::size_t k, int group)
{
    if (group == 0) {
        return list.values[k];
    }
    const Level level = std::min(Level(list.fine), scene.level(list.face[k]));
    return scene.pyramid().vertices(list.face[k], level, group).values;
}

/// Adds the texels that the probes of a line read.
HWY_INLINE void
addTexels(const FilterScene& scene, const LineWork& work, int group, ChannelSum& sum)
{
    const TexelReads& texels = work.texels;
    for (std::size_t k = 0; k < work.list.count; ++k) {
        if (texels.ownWeight[k] > 0 || texels.otherWeight[k] > 0) {
            const FaceId face = work.list.face[k];
            const LevelTexels base = scene.mips().texels(face, scene.level(face), group);
            sum.add(base.texel(TexelIndex{texels.own[k]}), texels.ownWeight[k]);
            sum.add(base.texel(TexelIndex{texels.other[k]}), texels.otherWeight[k]);
        }
    }
}

/// Sums the probes of one query for one group of channels.
HWY_INLINE void sumProbes(const FilterScene& scene,
                          const QueryWork& query,
                          const LineWork* works,
                          const ProbeLine* lines,
                          int group,
                          float* value)
{
    const bool blended = query.coarseShare > 0;
    const float* origin = valuesOf(scene, works[0].list, 0, group) + works[0].fine.pair[0];
    ChannelSum sum(origin);
    float weight = 0;
    for (std::size_t l = 0; l < query.count; ++l) {
        const LineWork& work = works[l];
        const ProbeList& list = work.list;
        ChannelSum fine(origin);
        ChannelSum coarse(origin);
        for (std::size_t k = 0; k < list.count; ++k) {
            const float* values = valuesOf(scene, list, k, group);
            fine.add(values, work.fine, k);
            if (blended) {
                coarse.add(values, work.coarse, k);
            }
        }
        if (work.texels.count > 0) {
            addTexels(scene, work, group, fine);
        }
        const auto ofLine = static_cast<float>(lines[l].weight);
        sum.addSums(fine, coarse, ofLine);
        weight += ofLine * work.weight;
    }
    sum.store(1 / weight, value);
}

/// Finds out what a line reads, and asks the caches for it.
HWY_INLINE void
prepareLine(const ProbeLine& line, double falloff, float coarseShare, LineWork& work)
{
    Reads& fine = work.fine;
    work.weight = findReads(work.list, line.support, falloff, coarseShare, fine, work.coarse);
    findTexels(work.list, coarseShare, {fine.first, fine.second, fine.third}, work.texels);
    for (std::size_t p = 0; p < work.list.count; ++p) {
        const float* values = work.list.values[p];
        hwy::Prefetch(values + work.fine.pair[p]);
        hwy::Prefetch(values + work.fine.single[p]);
        if (coarseShare > 0) {
            hwy::Prefetch(values + work.coarse.pair[p]);
            hwy::Prefetch(values + work.coarse.single[p]);
        }
    }
}

void finishQuery(const FilterScene& scene,
                 const FilterQueries& queries,
                 std::size_t q,
                 const QueryWork& query,
                 const Workspace& work,
                 const FilterResults& results)
{
    const FaceId face = queries.face[q];
    const bool hasCentre = std::isfinite(queries.u[q]) && std::isfinite(queries.v[q]);
    for (int group = 0; group < scene.mips().groups(); ++group) {
        GroupValue value;
        if (hasCentre) {
            sumProbes(scene,
                      query,
                      work.works + query.first,
                      work.lines + query.first,
                      group,
                      value.data());
        } else {
            std::copy_n(scene.mips().average(face, group), kGroupChannels, value.begin());
        }
        storeAnswer(results, q, group, scene.channels(), value);
    }
    const int level = std::min(query.fineLevel, scene.level(face).log2());
    std::size_t taps = 0;
    for (std::size_t l = query.first; l < query.first + query.count; ++l) {
        const LineWork& line = work.works[l];
        taps += line.list.count * (query.coarseShare > 0 ? 6 : 3) + line.texels.count;
    }
    storeCost(results,
              q,
              hasCentre ? QueryCost{static_cast<float>(level), static_cast<std::uint32_t>(taps)}
                        : QueryCost{0, 1});
}

/// Answers as many queries of a block as lines are walked together; returns how many.
std::size_t filterSome(const FilterScene& scene,
                       const FilterQueries& queries,
                       std::size_t begin,
                       std::size_t first,
                       std::size_t end,
                       double falloff,
                       const FilterResults& results,
                       Workspace& work)
{
    QueryWork some[kWalkedTogether];
    ProbeList* lists[kWalkedTogether];
    std::size_t lines = 0;
    std::size_t count = 0;
    for (; first + count < end && lines + kMostLines <= kWalkedTogether; ++count) {
        const std::size_t plan = first + count;
        QueryWork& query = some[count];
        query.first = lines;
        query.count = linesOf(work.plans, plan, queries.face[begin + plan], work.lines + lines);
        query.coarseShare = static_cast<float>(work.plans.coarse[plan]);
        query.fineLevel = static_cast<int>(work.plans.fine[plan]);
        for (std::size_t l = 0; l < query.count; ++l, ++lines) {
            lists[lines] = &work.works[lines].list;
            lists[lines]->fine = query.fineLevel;
        }
    }
    placeProbes(scene, std::span(work.lines, lines), std::span(lists, lines));
    for (std::size_t k = 0; k < count; ++k) {
        for (std::size_t l = some[k].first; l < some[k].first + some[k].count; ++l) {
            prepareLine(work.lines[l], falloff, some[k].coarseShare, work.works[l]);
        }
    }
    for (std::size_t k = 0; k < count; ++k) {
        finishQuery(scene, queries, begin + first + k, some[k], work, results);
    }
    return count;
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
            done += filterSome(scene, queries, begin, done, count, settings.falloff, results, work);
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
