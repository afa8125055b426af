// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/fit/fit.h"

#include "core/study/fit/fitter.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace trixel {
namespace {

/// What a face errs, and what its texels cost if nothing sees it.
void addFace(FitPlan& plan, const FitSource& source, const FittedSteps& steps, FaceId face)
{
    const Level before = source.texels.face(face).level();
    if (source.samples.isJudged(face)) {
        const double error = std::sqrt(steps.squares[face]);
        plan.errors[face] = static_cast<float>(error);
        plan.worstFace = std::max(plan.worstFace, error);
    }
    if (source.isUnseen[face] != 0) {
        ++plan.unseenFaces;
        plan.unseenTexelsBefore += before.texelCount();
        plan.unseenTexelsAfter += plan.levels[face].texelCount();
    }
    if (plan.levels[face] != before || steps.fitted.isMoved[face] != 0) {
        plan.fitted.addFace(face, steps.fitted.texels.face(face));
    }
}

FitPlan planOf(const FitSource& source, const FitPatches& patches, const FittedSteps& steps)
{
    const std::size_t faces = source.texels.faceCount();
    FitPlan plan;
    plan.levels = levelsAfter(source, steps.steps);
    plan.cost = levelCost(source.texels, plan.levels);
    plan.errors = FaceMap<float>(faces, std::numeric_limits<float>::quiet_NaN());
    std::vector<FaceId> all;
    for (std::size_t f = 0; f < faces; ++f) {
        addFace(plan, source, steps, faceId(f));
        all.push_back(faceId(f));
    }
    plan.rms = std::sqrt(patchMeanSquare(all, source.samples, steps.squares));
    for (std::size_t p = 0; p < patches.size(); ++p) {
        const double square = patchMeanSquare(patches.patch(p), source.samples, steps.squares);
        plan.worstPart = std::max(plan.worstPart, std::sqrt(square));
    }
    return plan;
}

} // namespace

Result<FitPlan> planFit(const Surface& surface,
                        const TexelStore& texels,
                        const FitSettings& settings,
                        Threads threads,
                        Progress& progress)
{
    check(surface.mesh().faceCount() == texels.faceCount(), "texels of this surface");
    if (!(settings.tolerance > 0) || !std::isfinite(settings.tolerance)) {
        return contentsError("tolerance: expected a number above 0, found " +
                             std::to_string(settings.tolerance));
    }
    if (settings.views.isEmpty()) {
        return contentsError("A fit needs at least one camera or view distance.");
    }
    StageProgress preparing(progress, 0, 0.1);
    const auto source =
        FitSource::make(surface, texels, settings.views, settings.unseen, threads, preparing);
    if (!source) {
        return tl::unexpected(source.error());
    }
    Fitter fitter(*source, surface, settings.tolerance, threads);
    StageProgress measuring(progress, 0.1, 0.4);
    if (const Status measured = fitter.measure(measuring); !measured) {
        return tl::unexpected(measured.error());
    }
    StageProgress choosing(progress, 0.4, 0.75);
    if (const Status chosen = fitter.choose(choosing); !chosen) {
        return tl::unexpected(chosen.error());
    }
    StageProgress settling(progress, 0.75, 1);
    const auto settled = fitter.settle(settling);
    if (!settled) {
        return tl::unexpected(settled.error());
    }
    return planOf(*source, fitter.patches(), *settled);
}

TexelPatch applyFit(const FitPlan& plan, TexelStore& texels)
{
    TexelPatch patch = plan.fitted;
    patch.swap(texels);
    return patch;
}

} // namespace trixel
