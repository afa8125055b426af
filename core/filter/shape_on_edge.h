// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/filter/filter_surface.h"

#include <cstddef>
#include <glm/geometric.hpp>

namespace trixel {

inline glm::dvec2 cornerOf(const FaceShape& shape, std::size_t vertex)
{
    return vertex == 0 ? glm::dvec2(0) : vertex == 1 ? shape.e1 : shape.e2;
}

/// The vertex beyond the edge from `start` to `end` in the plane, which a face of that shape calls
/// `edge` and runs along the other way.
inline glm::dvec2
vertexBeyond(const FaceShape& shape, std::size_t edge, glm::dvec2 start, glm::dvec2 end)
{
    const glm::dvec2 own = cornerOf(shape, edge);
    const glm::dvec2 from = cornerOf(shape, (edge + 1) % 3) - own;
    const glm::dvec2 to = start - end;
    // The turn from `from` to `to` as a complex factor; its size is 1 but for rounding and for
    // faces whose shape was replaced.
    const double squared = glm::dot(from, from);
    const glm::dvec2 turn(glm::dot(from, to) / squared, (from.x * to.y - from.y * to.x) / squared);
    const glm::dvec2 p = cornerOf(shape, (edge + 2) % 3) - own;
    return end + glm::dvec2(turn.x * p.x - turn.y * p.y, turn.y * p.x + turn.x * p.y);
}

} // namespace trixel
