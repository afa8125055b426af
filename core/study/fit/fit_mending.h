// SPDX-License-Identifier: GPL-3.0-or-later
//
// Giving levels back where a plan errs too much.
#pragma once

#include "core/study/fit/fit_patches.h"
#include "core/study/fit/fit_steps.h"

#include <vector>

namespace trixel {

/// Mends plans of one fit. Refers to its source and its patches.
class FitMender
{
public:
    /// How patches get back what they need.
    enum class Manner {
        Gently, ///< a level a face, those faces first that err most for the texels they get
        Wholly, ///< all levels of all faces of the patch and about it
    };

    /// \param most  mean square that a patch may err
    FitMender(const FitSource& source, const FitPatches& patches, double most);

    /// Gives faces of each patch that errs too much levels back. However many patches ask for it, a
    /// face gets back one level at a time: what that mends is only known afterwards. Returns
    /// whether there was anything to give.
    /// \param squares  mean square error of each face; what should be gained is taken off, so that
    ///                 patches that overlap do not mend the same twice
    bool mend(Manner manner, FaceMap<double>& squares, FitSteps& steps);

private:
    struct Mending;

    bool mendGently(std::span<const FaceId> patch);
    bool mendWholly(std::span<const FaceId> patch);
    std::vector<Mending> mendings(std::span<const FaceId> patch) const;
    double texelsToMend(FaceId face) const;
    bool giveBack(FaceId face);
    bool giveBackAbout(FaceId face);
    template <class Visit>
    void forAbout(FaceId face, const Visit& visit) const;

    const FitSource& m_source;
    const FitPatches& m_patches;
    double m_most;
    FitSteps m_before; ///< steps before they were mended
    // While mending.
    FaceMap<double>* m_squares = nullptr;
    FitSteps* m_steps = nullptr;
};

} // namespace trixel
