// SPDX-License-Identifier: GPL-3.0-or-later
//
// Coarser texels chosen so that the picture stays as it was, rather than that each is the mean of
// the texels it replaces.
#pragma once

#include "core/filter/filter_method.h"
#include "core/study/fit_samples.h"

#include <memory>

namespace trixel {

/// What a fit starts from. Refers to the surface and the store's texels, which it shares.
struct FitSource
{
    std::shared_ptr<const FilterSurface> shapes;
    TexelStore texels;
    TexelStore floats; ///< the same texels as float
    FilterScene scene; ///< of `texels`
    FitSamples samples;
    /// What corrected texels are kept within: the values the texels span, [0,1] for integers.
    float least = 0, most = 1;

    /// Fails only when cancelled.
    static Result<FitSource> make(const Surface& surface,
                                  const TexelStore& texels,
                                  const SceneViews& views,
                                  Threads threads,
                                  Progress& progress);
};

/// Makes the texels of other levels, again and again: what should be seen at them is remembered.
class Coarsener
{
public:
    /// \param source  must outlive it
    explicit Coarsener(const FitSource& source);

    /// The texels at other levels, none above the source's (checked). A face that keeps its level
    /// keeps its bytes, a constant face stays constant. The others begin as means of the texels
    /// they replace; then they are moved, a few times over, by what `exact` still finds missing at
    /// their centroids when it looks with the finest covered footprint: the filter's floor grows
    /// with the texels and would blur the picture otherwise. Fails only when cancelled.
    Result<TexelStore> coarsened(const FaceMap<Level>& levels, Threads threads, Progress& progress);

private:
    struct Correction;

    bool isCorrected(const TexelStore& coarse, FaceId face) const;
    Correction correctionOf(const TexelStore& coarse) const;
    void remember(const TexelStore& coarse, const Correction& correction, Threads threads);
    Status correct(TexelStore& coarse, Threads threads, Progress& progress);

    const FitSource& m_source;
    /// Of each level, what should be seen at a face's texels, channel after channel; empty where
    /// nobody asked yet.
    std::vector<FaceMap<std::vector<float>>> m_wanted;
};

} // namespace trixel
