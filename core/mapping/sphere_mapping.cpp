// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mapping/sphere_mapping.h"

#include "core/mapping/sphere.h"

namespace trixel {

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
