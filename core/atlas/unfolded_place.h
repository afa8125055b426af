// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/adjacency.h"

#include <glm/vec2.hpp>

namespace trixel {

/// A point of the surface.
struct SurfacePlace
{
    FaceId face{};
    glm::dvec2 uv{0};
};

/// Where a point beside a face lies, neighbours unfolded as `acrossEdge` does: a few of them at
/// most, enough for borders and padding. Beyond a border it stays outside of the face before it.
SurfacePlace unfoldedPlace(const Adjacency& adjacency, FaceId face, glm::dvec2 uv);

} // namespace trixel
