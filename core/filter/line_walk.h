// SPDX-License-Identifier: GPL-3.0-or-later
//
// A straight line over the mesh, from face to face.
#pragma once

#include "core/filter/filter_surface.h"

#include <array>
#include <cstddef>
#include <glm/vec2.hpp>

namespace trixel {

/// The part of a line within one face: (u,v) = start + (t - begin) step.
struct LineSegment
{
    FaceId face{};
    double begin = 0;
    double end = 0;
    glm::dvec2 start{0};
    glm::dvec2 step{0};
};

/// Faces that a line may run through; beyond them is as beyond a border.
inline constexpr std::size_t kMostSegments = 512;

struct LineWalk
{
    std::size_t count = 0;
    /// Where the line ended: the reach, or before it where there is a border.
    double end = 0;
    std::array<LineSegment, kMostSegments> segments;
};

/// Follows the line from t = 0 to t = reach.
/// \param start  in the face
/// \param step   change of (u,v) for t = 1; finite
void walkLine(const FilterSurface& surface,
              FaceId face,
              glm::dvec2 start,
              glm::dvec2 step,
              double reach,
              LineWalk& walk);

} // namespace trixel
