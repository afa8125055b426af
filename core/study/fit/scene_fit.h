// SPDX-License-Identifier: GPL-3.0-or-later
//
// All that a scene lets a texture do without: levels, subdivision and filter.
#pragma once

#include "core/study/fit/fit.h"
#include "core/study/fit/fit_method.h"
#include "core/study/fit/fit_subdivision.h"

#include <optional>
#include <vector>

namespace trixel {

/// A plan, and what is worth knowing before it is applied.
struct SceneFit
{
    FitPlan plan;
    /// The texels with the plan applied; they share what did not change with those it was made
    /// from.
    TexelStore fitted;
    /// The fastest filter method that is good enough for the fitted texels.
    std::optional<FitMethod> method;
    /// Up to the coarsest subdivision that is good enough.
    std::vector<SubdivisionError> subdivision;
};

/// Plans a fit and asks what it leaves: `planFit`, then `fitMethod` and `subdivisionErrors` of what
/// it leads to. The store stays as it is. Fails as `planFit` does.
Result<SceneFit> fitScene(const Surface& surface,
                          const TexelStore& texels,
                          const FitSettings& settings,
                          Threads threads,
                          Progress& progress);

} // namespace trixel
