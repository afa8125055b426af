// SPDX-License-Identifier: GPL-3.0-or-later
//
// Coarser texels chosen so that the picture stays as it was, rather than that each is the mean of
// the texels it replaces.
#pragma once

#include "core/filter/filter_method.h"
#include "core/study/fit/fit_samples.h"

#include <glm/vec4.hpp>
#include <memory>
#include <optional>
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
    /// What corrected texels are kept within: the values the texels span, [0,1] for integers.
    float least = 0, most = 1;

    /// Fails only when cancelled.
    static Result<FitSource> make(const Surface& surface,
                                  const TexelStore& texels,
                                  const SceneViews& views,
                                  Threads threads,
                                  Progress& progress);
};

/// Every channel of every query as `exact` sees it, channel after channel. Fails only when
/// cancelled.
Result<std::vector<float>> seenThroughExact(const FilterScene& scene,
                                            const QueryArrays& queries,
                                            Threads threads,
                                            Progress& progress);

/// Texels at other levels, and how well they do.
struct FittedTexels
{
    TexelStore texels; ///< in the source's format
    /// Whether a face's texels were moved, be it at its own level.
    FaceMap<char> isMoved;
    /// Mean square of what a face's points miss, as the sums tell that moved them: for planning,
    /// not for judging. 0 where nothing near changed.
    FaceMap<double> squares;
};

/// Makes the texels of other levels, again and again: what should be seen and what was found before
/// is remembered.
class Coarsener
{
public:
    /// \param source  must outlive it
    explicit Coarsener(const FitSource& source);

    /// The texels at other levels, none above the source's (checked). They begin as means of the
    /// texels they replace, or as what was found for that face and level before; then they are
    /// moved so that `exact` sees what it saw, by least squares over points all over the surface,
    /// looked at with the finest covered footprint. That is needed because the filter's floor grows
    /// with the texels and would blur the picture. It grows about their vertices too, so that faces
    /// that keep their level next to coarser ones have their texels moved as well. All others keep
    /// their bytes, and a constant face stays constant. Fails only when cancelled.
    /// \param steps  of the search for texels
    Result<FittedTexels>
    fitted(const FaceMap<Level>& levels, int steps, Threads threads, Progress& progress);

private:
    struct Points;

    TexelStore begin(const FaceMap<Level>& levels) const;
    FaceMap<char> movable(const TexelStore& coarse) const;
    Points pointsFor(const TexelStore& coarse, const FaceMap<char>& isMoved) const;
    Status remember(const Points& points, Threads threads, Progress& progress);
    std::vector<glm::vec4> wanted(const Points& points, int group) const;
    Status move(TexelStore& coarse,
                const Points& points,
                int steps,
                FittedTexels& fitted,
                Threads threads,
                Progress& progress);

    const FitSource& m_source;
    /// Of each level of points, what should be seen at a face's, channel after channel; empty where
    /// nobody asked yet.
    std::vector<FaceMap<std::vector<float>>> m_wanted;
    /// Of each level, the float texels that were found last for a face.
    std::vector<FaceMap<std::optional<FaceTexels>>> m_found;
};

} // namespace trixel
