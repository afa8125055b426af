// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/level.h"
#include "core/footprint/footprint.h"

namespace trixel {

/// What there is to say of a footprint on a face, for people and for maps.
struct EllipseReport
{
    FootprintEllipse ellipse; ///< axes in (u,v) and their lengths in the metric
    double area = 0;          ///< π major minor, metric units squared
    /// Major over minor: what a relative error of the vectors may grow by in the minor axis. 1 for
    /// a circle or nothing, infinite where only the minor axis vanishes.
    double condition = 1;
    double width = 0; ///< texels of the base level across: 2 minor over a texel's edge
    /// Level whose texels are as wide as the ellipse across, between 0 and the base; fractional.
    double level = 0;
};

/// Level with texels of the width given: log2Edge - log2(width), limited to [0, base]; a width of 0
/// gives the base.
/// \param log2Edge  log2 of the edge length that level 0's one texel has, in the width's units;
///                  interpolated from the vertices it makes the level continuous over a mesh
double levelForWidth(double width, double log2Edge, Level base);

/// \param corners   world positions
/// \param base      level of the face
/// \param log2Edge  see `levelForWidth`
EllipseReport describe(const Footprint& footprint,
                       const std::array<glm::vec3, 3>& corners,
                       Level base,
                       double log2Edge);

/// The same with the mean log2 of the face's own edges, which jumps between faces of unlike size.
EllipseReport
describe(const Footprint& footprint, const std::array<glm::vec3, 3>& corners, Level base);

} // namespace trixel
