// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/fit/scene_fit.h"

#include <memory>

namespace trixel {
namespace {

Result<std::optional<FitMethod>> fastestMethod(const Surface& surface,
                                               const TexelStore& texels,
                                               const FitSettings& settings,
                                               Threads threads,
                                               Progress& progress)
{
    StageProgress building(progress, 0, 0.2);
    const auto shapes = std::make_shared<FilterSurface>(
        FilterSurface::fromMesh(surface.mesh(), surface.adjacency()));
    const auto scene = FilterScene::build(shapes, texels, threads, building);
    if (!scene) {
        return tl::unexpected(scene.error());
    }
    StageProgress measuring(progress, 0.2, 1);
    return fitMethod(surface, *scene, settings.views, settings.tolerance, threads, measuring);
}

} // namespace

Result<SceneFit> fitScene(const Surface& surface,
                          const TexelStore& texels,
                          const FitSettings& settings,
                          Threads threads,
                          Progress& progress)
{
    StageProgress planning(progress, 0, 0.88);
    auto plan = planFit(surface, texels, settings, threads, planning);
    if (!plan) {
        return tl::unexpected(plan.error());
    }
    SceneFit fit{std::move(*plan), texels, std::nullopt, {}};
    applyFit(fit.plan, fit.fitted);
    StageProgress measuring(progress, 0.88, 0.97);
    auto method = fastestMethod(surface, fit.fitted, settings, threads, measuring);
    if (!method) {
        return tl::unexpected(method.error());
    }
    fit.method = std::move(*method);
    fit.subdivision = subdivisionErrors(surface.mesh(), settings.views);
    if (!progress.report(1)) {
        return cancelled();
    }
    return fit;
}

} // namespace trixel
