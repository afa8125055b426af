// SPDX-License-Identifier: GPL-3.0-or-later
//
// Straight lines over a surface: where a filter's tap lies when it leaves the face of the query.
#pragma once

#include "core/filter/filter_surface.h"

#include <glm/mat2x2.hpp>
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
    /// The vectors that were carried along, in (u,v) of the face where the walk ended.
    glm::dmat2 carried{0};
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
/// \param carried  two further vectors in (u,v) of that face, turned along with the faces
SurfaceWalk walkStraight(const FilterSurface& surface,
                         const SurfacePlace& from,
                         glm::dvec2 step,
                         const glm::dmat2& carried = glm::dmat2(0));

} // namespace trixel
