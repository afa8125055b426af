// SPDX-License-Identifier: GPL-3.0-or-later
//
// The search for the levels of a fit, round by round.
#pragma once

#include "core/study/fit/fit_mending.h"
#include "core/study/fit/fitted_texels.h"

#include <optional>
#include <vector>

namespace trixel {

/// Levels given up, the texels found for them, and how they do.
struct FittedSteps
{
    FitSteps steps;
    FittedTexels fitted;
    FaceMap<double> squares; ///< mean square error of each face, as `exact` sees it
};

/// Lowers levels as far as no patch errs more than the tolerance. Everything fails only when
/// cancelled.
class Fitter
{
public:
    /// \param source  must outlive it
    Fitter(const FitSource& source, const Surface& surface, double tolerance, Threads threads);

    /// Measures every face at every level, all faces together.
    Status measure(Progress& progress);
    /// Chooses steps, and again and again gives some back where patches err too much and takes more
    /// where they err too little, learning what faces err among others that take other steps.
    Status choose(Progress& progress);
    /// The same with `exact` as the judge. Returns the plan of fewest texels that holds.
    Result<FittedSteps> settle(Progress& progress);

    const FitPatches& patches() const { return m_patches; }

private:
    Result<std::vector<float>> seen(const FilterScene& scene, Progress& progress) const;
    Status fit(int searchSteps, Progress& progress);
    Status judge(Progress& progress);
    bool adjust();
    void give(double part);
    void learn();
    bool isAnyExceeded() const;
    bool anyPasses(const FaceMap<double>& squares) const;

    const FitSource& m_source;
    double m_most; ///< mean square of a patch
    Threads m_threads;
    Coarsener m_coarsener;
    FaceMap<Level> m_before;
    FitPatches m_patches;
    FitMender m_mender;
    FitOptions m_options;
    std::vector<float> m_was; ///< what the samples see of the texels as they are
    FitSteps m_steps;
    FittedTexels m_fitted; ///< at those steps
    FaceMap<double> m_squares;
};

} // namespace trixel
