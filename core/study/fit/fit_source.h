// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/filter/filter_scene.h"
#include "core/study/fit/fit_rim.h"
#include "core/texture/texel_store.h"

#include <memory>
#include <vector>

namespace trixel {

/// What a fit starts from. Refers to the surface and the store's texels, which it shares.
struct FitSource
{
    std::shared_ptr<const FilterSurface> shapes;
    TexelStore texels;
    TexelStore floats; ///< the same texels as float
    FilterScene scene; ///< of `texels`
    FitSamples samples;
    FitRim rim;
    FaceMap<char> isUnseen; ///< by any view

    /// Finest footprint that reaches a face, world units per pixel; infinite where none does.
    double spacing(FaceId face) const;
    /// What a face counts for when texels are looked for: its pixels where it is judged, a tenth of
    /// those that it would fill on the rim, so that what is seen of it by its edge stays in tune
    /// with the rest; 0 elsewhere.
    double weight(FaceId face) const;
    /// What corrected texels are kept within: the values the texels span, [0,1] for integers.
    float least = 0, most = 1;

    /// Fails only when cancelled.
    static Result<FitSource> make(const Surface& surface,
                                  const TexelStore& texels,
                                  const SceneViews& views,
                                  UnseenFaces unseen,
                                  Threads threads,
                                  Progress& progress);
};

/// Every channel of every query as `exact` sees it, channel after channel. Fails only when
/// cancelled.
Result<std::vector<float>> seenThroughExact(const FilterScene& scene,
                                            const QueryArrays& queries,
                                            Threads threads,
                                            Progress& progress);

} // namespace trixel
