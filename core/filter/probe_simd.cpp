// SPDX-License-Identifier: GPL-3.0-or-later
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/filter/probe_simd.cpp"
// clang-format off
#include <hwy/foreach_target.h> // before all others
// clang-format on

#include "core/filter/probe_simd.h"

#include "core/filter/probe_answer_simd-inl.h"
#include "core/filter/probe_plan_simd-inl.h"

HWY_BEFORE_NAMESPACE();
namespace trixel::HWY_NAMESPACE {

/// Room for one block of queries.
struct Workspace
{
    PlanInputs inputs;
    ProbePlans plans;
    ProbeBatch batch;
    Reads reads;
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

void filterBlock(const FilterScene& scene,
                 const FilterQueries& queries,
                 const ProbeSettings& settings,
                 const FilterResults& results)
{
    // Itself thread-local, it would be cleared for every target whenever any thread starts.
    static thread_local const auto kept = std::make_unique<Workspace>();
    Workspace& work = *kept;
    for (std::size_t begin = 0; begin < queries.size(); begin += ProbePlans::kSize) {
        const std::size_t count = std::min(ProbePlans::kSize, queries.size() - begin);
        gatherInputs(scene, queries, begin, count, work.inputs);
        planAll(work.inputs, count, settings, work.plans);
        for (std::size_t done = 0; done < count;) {
            const auto faces = queries.face.subspan(begin, count);
            const std::size_t some =
                placeSome(scene, work.plans, faces, settings.falloff, done, work.batch);
            finishSome(scene, queries, begin + done, some, results, work.batch, work.reads);
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
