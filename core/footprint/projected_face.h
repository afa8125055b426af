// SPDX-License-Identifier: GPL-3.0-or-later
//
// Footprints through a camera's matrix: homogeneous, so that nothing is divided by a vanishing w.
#pragma once

#include "core/footprint/footprint.h"
#include "core/footprint/screen_derivatives.h"

#include <array>
#include <glm/mat4x4.hpp>
#include <optional>

namespace trixel {

/// A face as a camera sees it: homogeneous pixels (x, y, w), which are affine in (u,v); the screen
/// position is (x/w, y/w).
struct ProjectedFace
{
    glm::dvec3 origin{0, 0, 1}; ///< of V0
    glm::dvec3 perU{0};
    glm::dvec3 perV{0};

    glm::dvec3 at(glm::dvec2 uv) const { return origin + uv.x * perU + uv.y * perV; }
};

/// \param toPixels  world → clip coordinates whose x/w and y/w are pixels; z is not used
ProjectedFace projectedFace(const glm::dmat4& toPixels, const std::array<glm::vec3, 3>& corners);

/// The textbook's way: quotient rule, which divides by w² wherever the point lies.
ScreenDerivatives screenDerivatives(const ProjectedFace& face, glm::dvec2 uv);

/// Footprint of a pixel at a point of the face, analytic: with A = w² F, which is always finite,
/// and Δ the determinant of (p, perU, perV), the lengths are minor = w²/σ1(A) and major = w
/// σ1(A)/|Δ|, limited as in `footprintOf(ScreenDerivatives)`. Goes to zero as w does. \param uv of
/// the face \param maxLength  in uv \param nearW      clips: nothing where w <= nearW or w <= 0
/// (behind the camera nothing is seen)
std::optional<Footprint>
footprintOf(const ProjectedFace& face, glm::dvec2 uv, double maxLength = 64.0, double nearW = 0.0);

} // namespace trixel
