// SPDX-License-Identifier: GPL-3.0-or-later
//
// Coarser texels chosen so that the picture stays as it was, rather than that each is the mean of
// the texels it replaces.
#pragma once

#include "core/study/fit/fit_points.h"

#include <optional>
#include <vector>

namespace trixel {

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
    TexelStore begin(const FaceMap<Level>& levels) const;
    FaceMap<char> movable(const TexelStore& coarse) const;
    Status move(TexelStore& coarse,
                const FitPoints& points,
                int steps,
                FittedTexels& fitted,
                Threads threads,
                Progress& progress);

    const FitSource& m_source;
    FitWanted m_wanted;
    /// Of each level, the float texels that were found last for a face.
    std::vector<FaceMap<std::optional<FaceTexels>>> m_found;
};

} // namespace trixel
