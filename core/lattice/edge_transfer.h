// SPDX-License-Identifier: GPL-3.0-or-later
//
// Crossing a mesh edge in face coordinates. With t along the edge and h the height above it,
// all nine pairs of edges share one map: (t,h) → (1-t, -h), and vectors negate.
#pragma once

#include "core/base/ids.h"

#include <glm/vec2.hpp>

namespace trixel {

/// Position relative to an edge: t along it from its start in [0,1], h above it (0 on the edge).
struct EdgeCoord
{
    double t = 0;
    double h = 0;
};

/// E0 gives (u,v), E1 (v,w), E2 (w,u).
EdgeCoord toEdge(LocalEdge edge, glm::dvec2 uv);

/// The inverse: E0 (t,h), E1 (1-t-h,t), E2 (h,1-t-h).
glm::dvec2 fromEdge(LocalEdge edge, EdgeCoord coord);

/// The point, given in a face, in the coordinates of its neighbour: the neighbour is unfolded as
/// the parallelogram completion, which is what Ptex addresses by (exact for congruent faces).
/// \param from  the edge as the face numbers it
/// \param to    the same edge as the neighbour numbers it
glm::dvec2 acrossEdge(LocalEdge from, LocalEdge to, glm::dvec2 uv);

} // namespace trixel
