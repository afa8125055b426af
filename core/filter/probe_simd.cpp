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

#include <cmath>
#include <hwy/cache_control.h>

HWY_BEFORE_NAMESPACE();
namespace trixel::HWY_NAMESPACE {

/// The probes of one query and what they read.
struct QueryWork
{
    ProbeList list;
    Reads fine, coarse;
    float coarseShare = 0; ///< of the coarser level
    float weight = 0;      ///< of all probes
};

/// Room for one block of queries and for those of them at work.
struct Workspace
{
    PlanInputs inputs;
    ProbePlans plans;
    QueryWork queries[kWalkedTogether];
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

/// Sums the probes of one query for one group of channels.
HWY_INLINE void sumProbes(const FilterScene& scene, const QueryWork& work, int group, float* value)
{
    const ProbeList& list = work.list;
    const bool blended = work.coarseShare > 0;
    const auto valuesOf = [&](std::size_t k) {
        if (group == 0) {
            return list.values[k];
        }
        const Level level = std::min(Level(list.fine), scene.level(list.face[k]));
        return scene.pyramid().vertices(list.face[k], level, group).values;
    };
    const float* origin = valuesOf(0) + work.fine.pair[0];
    ChannelSum fine(origin);
    ChannelSum coarse(origin);
    for (std::size_t k = 0; k < list.count; ++k) {
        const float* values = valuesOf(k);
        fine.add(values, work.fine, k);
        if (blended) {
            coarse.add(values, work.coarse, k);
        }
    }
    fine.store(coarse, 1 / work.weight, value);
}

/// Finds out what a query reads, and asks the caches for it.
HWY_INLINE void prepareQuery(const ProbePlans& plans, std::size_t k, QueryWork& work)
{
    work.coarseShare = static_cast<float>(plans.coarse[k]);
    work.weight = findReads(work.list, plans.support[k], work.coarseShare, work.fine, work.coarse);
    for (std::size_t p = 0; p < work.list.count; ++p) {
        const float* values = work.list.values[p];
        hwy::Prefetch(values + work.fine.pair[p]);
        hwy::Prefetch(values + work.fine.single[p]);
        if (work.coarseShare > 0) {
            hwy::Prefetch(values + work.coarse.pair[p]);
            hwy::Prefetch(values + work.coarse.single[p]);
        }
    }
}

void finishQuery(const FilterScene& scene,
                 const FilterQueries& queries,
                 std::size_t q,
                 const QueryWork& work,
                 const FilterResults& results)
{
    const FaceId face = queries.face[q];
    const bool hasCentre = std::isfinite(queries.u[q]) && std::isfinite(queries.v[q]);
    for (int group = 0; group < scene.mips().groups(); ++group) {
        GroupValue value;
        if (hasCentre) {
            sumProbes(scene, work, group, value.data());
        } else {
            std::copy_n(scene.mips().average(face, group), kGroupChannels, value.begin());
        }
        storeAnswer(results, q, group, scene.channels(), value);
    }
    const int level = std::min(work.list.fine, scene.level(face).log2());
    const std::size_t taps = work.list.count * (work.coarseShare > 0 ? 6 : 3);
    storeCost(results,
              q,
              hasCentre ? QueryCost{static_cast<float>(level), static_cast<std::uint32_t>(taps)}
                        : QueryCost{0, 1});
}

void filterBlock(const FilterScene& scene,
                 const FilterQueries& queries,
                 const ProbeSettings& settings,
                 const FilterResults& results)
{
    HWY_ALIGN static thread_local Workspace work;
    ProbeList* lists[kWalkedTogether];
    for (std::size_t k = 0; k < kWalkedTogether; ++k) {
        lists[k] = &work.queries[k].list;
    }
    for (std::size_t begin = 0; begin < queries.size(); begin += ProbePlans::kSize) {
        const std::size_t count = std::min(ProbePlans::kSize, queries.size() - begin);
        gatherInputs(scene, queries, begin, count, work.inputs);
        planAll(work.inputs, count, settings, work.plans);
        for (std::size_t first = 0; first < count; first += kWalkedTogether) {
            const std::size_t some = std::min(kWalkedTogether, count - first);
            placeProbes(scene,
                        queries.face.subspan(begin + first, some),
                        work.plans,
                        first,
                        std::span(lists, some));
            for (std::size_t k = 0; k < some; ++k) {
                prepareQuery(work.plans, first + k, work.queries[k]);
            }
            for (std::size_t k = 0; k < some; ++k) {
                finishQuery(scene, queries, begin + first + k, work.queries[k], results);
            }
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
