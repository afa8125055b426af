// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mapping/sphere_mapping.h"

#include "core/mapping/sphere.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <numbers>

namespace trixel {

Result<glm::dmat3> sphereTurn(glm::dvec3 axis, double turn)
{
    const double length = glm::length(axis);
    if (!(length > 0) || !std::isfinite(length)) {
        return contentsError("the sphere's axis has no direction");
    }
    const glm::dvec3 up = axis / length;
    const glm::dvec3 hint = std::abs(up.z) < 0.9 ? glm::dvec3(0, 0, 1) : glm::dvec3(0, -1, 0);
    const glm::dvec3 ahead = glm::normalize(hint - glm::dot(hint, up) * up);
    const double angle = turn * std::numbers::pi / 180;
    const glm::dvec3 front = std::cos(angle) * ahead + std::sin(angle) * glm::cross(up, ahead);
    // Rows of the turn are the sphere's axes: x to the right of who looks from outside, y up, z to
    // the front.
    return glm::transpose(glm::dmat3(glm::cross(up, front), up, front));
}

SphereMapping::SphereMapping(const TriangleMesh& mesh, glm::dvec3 centre, const glm::dmat3& turned)
    : m_mesh(mesh)
    , m_centre(centre)
    , m_turned(turned)
{
}

ImagePlace SphereMapping::at(FaceId face, glm::dvec2 uv, double step) const
{
    const auto corners = m_mesh.corners(face);
    const glm::dvec3 origin(corners[0]);
    const glm::dvec3 perU = m_turned * (glm::dvec3(corners[1]) - origin);
    const glm::dvec3 perV = m_turned * (glm::dvec3(corners[2]) - origin);
    const glm::dvec3 direction = m_turned * (origin - m_centre) + uv.x * perU + uv.y * perV;
    const Footprint footprint = sphereFootprint(direction, step * perU, step * perV);
    return {true, sphereUv(direction), footprint};
}

} // namespace trixel
