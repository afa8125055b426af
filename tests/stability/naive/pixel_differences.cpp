// SPDX-License-Identifier: GPL-3.0-or-later
//
// The difference of what neighbouring pixels see: beyond the far edge of the face, the (u,v) of its
// neighbour.
#include "core/footprint/footprint.h"

#include <glm/geometric.hpp>

namespace trixel {
namespace {

glm::dvec2 seen(const PixelRay& ray, const std::array<glm::vec3, 3>& corners, const glm::dvec3& d)
{
    const glm::dvec3 e1 = glm::dvec3(corners[1]) - glm::dvec3(corners[0]);
    const glm::dvec3 e2 = glm::dvec3(corners[2]) - glm::dvec3(corners[0]);
    const glm::dvec3 s = ray.origin - glm::dvec3(corners[0]);
    const glm::dvec3 p = glm::cross(d, e2);
    const glm::dvec2 uv =
        glm::dvec2(glm::dot(s, p), glm::dot(d, glm::cross(s, e1))) / glm::dot(e1, p);
    return uv.x + uv.y <= 1 ? uv : 1.0 - uv;
}

} // namespace

Footprint
screenFootprint(const PixelRay& ray, const std::array<glm::vec3, 3>& corners, double /*maxLength*/)
{
    const glm::dvec2 here = seen(ray, corners, ray.direction);
    return {seen(ray, corners, ray.direction + ray.perX) - here,
            seen(ray, corners, ray.direction + ray.perY) - here};
}

} // namespace trixel
