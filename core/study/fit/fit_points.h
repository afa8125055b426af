// SPDX-License-Identifier: GPL-3.0-or-later
//
// Where a fit looks while it searches for texels, and what it should see there.
#pragma once

#include "core/study/fit/fit_equations.h"
#include "core/study/fit/fit_source.h"

#include <vector>

namespace trixel {

struct FitPoints
{
    QueryArrays queries;
    std::vector<PointRange> ranges;
    std::vector<Level> levels; ///< of each range: its points are the centroids of such texels
};

/// Points on all faces whose texels move, and on those about them that see it, but for faces that
/// count for nothing. Up to four a texel, but no more than the face has at its own level, nor than
/// four a pixel.
/// \param levels   that the faces have now
/// \param isMoved  of each face
FitPoints
fitPoints(const FitSource& source, const FaceMap<Level>& levels, const FaceMap<char>& isMoved);

/// What `exact` sees of the source, remembered.
class FitWanted
{
public:
    /// \param source  must outlive it
    explicit FitWanted(const FitSource& source);

    /// Looks at the points that nobody asked for yet. Fails only when cancelled.
    Status look(const FitPoints& points, Threads threads, Progress& progress);
    /// Four channels of every point, all of which were looked at.
    std::vector<Quad> group(const FitPoints& points, int group) const;

private:
    const FitSource& m_source;
    /// Of each level of points, what should be seen at a face's, channel after channel; empty where
    /// nobody asked yet.
    std::vector<FaceMap<std::vector<float>>> m_seen;
};

} // namespace trixel
