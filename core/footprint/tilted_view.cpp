// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/footprint/tilted_view.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

namespace trixel {

PixelRay tiltedRay(const TiltedView& view,
                   const std::array<glm::vec3, 3>& corners,
                   glm::dvec2 uv,
                   double degrees)
{
    constexpr double kMostDegrees = 89.99; // along the face nothing of it is seen
    const glm::dvec3 origin(corners[0]);
    const glm::dvec3 e1 = glm::dvec3(corners[1]) - origin;
    const glm::dvec3 e2 = glm::dvec3(corners[2]) - origin;
    const glm::dvec3 normal = glm::normalize(glm::cross(e1, e2));
    const glm::dvec3 towards = glm::normalize(view.towards.x * e1 + view.towards.y * e2);
    const double angle = std::clamp(degrees, 0.0, kMostDegrees) * std::numbers::pi / 180;

    PixelRay ray;
    const glm::dvec3 toEye = std::cos(angle) * normal + std::sin(angle) * towards;
    ray.origin = origin + uv.x * e1 + uv.y * e2 + view.distance * toEye;
    ray.direction = -toEye;
    // Right of the picture is across the lean; the eye's own up is what is left.
    const glm::dvec3 right = glm::cross(ray.direction, normal);
    const glm::dvec3 across = angle > 1e-9 ? glm::normalize(right) : glm::cross(normal, towards);
    ray.perX = view.radiansPerPixel * across;
    ray.perY = view.radiansPerPixel * glm::cross(ray.direction, across);
    return ray;
}

} // namespace trixel
