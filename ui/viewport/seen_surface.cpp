// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/viewport/seen_surface.h"

#include <glm/geometric.hpp>

namespace trixel::ui {

LimitSurface::Evaluator& SeenSurface::at(FaceId face) const
{
    if (!m_evaluator) {
        m_evaluator.emplace(m_limit->surface());
    }
    m_evaluator->moveTo(face);
    return *m_evaluator;
}

std::optional<SurfacePoint> SeenSurface::raycast(const Ray& ray) const
{
    return m_limit ? m_limit->raycast(ray) : m_cage.bvh().raycast(ray);
}

std::optional<SurfacePoint> SeenSurface::closestPoint(glm::vec3 position, float maxDistance) const
{
    return m_limit ? m_limit->closestPoint(position, maxDistance)
                   : m_cage.bvh().closestPoint(position, maxDistance);
}

glm::vec3 SeenSurface::position(FaceId face, glm::vec2 uv) const
{
    return m_limit ? glm::vec3(at(face).position(glm::dvec2(uv)))
                   : pointAt(m_cage.mesh().corners(face), uv.x, uv.y);
}

std::array<glm::vec3, 3> SeenSurface::tangentFace(FaceId face, glm::vec2 uv) const
{
    return m_limit ? at(face).at(glm::dvec2(uv)).tangentFace(glm::dvec2(uv))
                   : m_cage.mesh().corners(face);
}

glm::vec3 SeenSurface::normal(FaceId face, glm::vec2 uv) const
{
    const auto c = tangentFace(face, uv);
    const glm::vec3 cross = glm::cross(c[1] - c[0], c[2] - c[0]);
    const float area = glm::length(cross);
    return area > 0 ? cross / area : glm::vec3(0);
}

} // namespace trixel::ui
