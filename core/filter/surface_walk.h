// SPDX-License-Identifier: GPL-3.0-or-later
//
// Straight lines over a surface: where a filter's tap lies when it leaves the face of the query.
#pragma once

#include "core/filter/filter_surface.h"

#include <glm/vec2.hpp>

namespace trixel {

/// A point of the surface.
struct SurfacePlace
{
    FaceId face{};
    glm::dvec2 uv{0};
};

/// Where a walk ended.
struct SurfaceWalk
{
    SurfacePlace end;
    /// The vector that was carried along, in (u,v) of the face where the walk ended.
    glm::dvec2 carried{0};
    /// Whether a border or the limit of crossings ended it early.
    bool stopped = false;
};

/// Most edges that a walk crosses; it stops in the face reached then. A bound for footprints that
/// are hundreds of faces wide, which no filter of few taps resolves anyway.
inline constexpr int kMostCrossings = 256;

/// Walks a straight line over the surface, each face unfolded into the plane of the one before
/// (`FilterSurface::crossing`), and stops at a border.
/// \param from     inside the face
/// \param step     finite, in (u,v) of that face
/// \param carried  a further vector in (u,v) of that face, turned along with the faces
SurfaceWalk walkStraight(const FilterSurface& surface,
                         const SurfacePlace& from,
                         glm::dvec2 step,
                         glm::dvec2 carried = glm::dvec2(0));

} // namespace trixel
