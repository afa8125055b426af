// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/error_scale.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

namespace trixel {

namespace {

/// A camera that moves a little finds the faces at its border ready.
constexpr double kMargin = 1.1;

} // namespace

ErrorScale::ErrorScale(const std::optional<PictureView>& view)
    : m_view(view)
{
    if (m_view) {
        const double f = m_view->focalLength;
        m_eye = glm::dvec3(glm::inverse(m_view->toCamera)[3]);
        m_reach = kMargin * m_view->halfSize;
        m_planes = {std::hypot(f, m_reach.x), std::hypot(f, m_reach.y)};
        m_corner = std::hypot(f, m_reach.x, m_reach.y);
    }
}

// With p the point in the camera's frame, w its depth and a its place in the picture from the
// middle, the picture moves by J = [f (e_x, e_y) - a e_z] / w for a unit of length: J Jᵀ is
// (f² I + a aᵀ) / w², so by sqrt(f² + |a|²) / w at most.
double ErrorScale::at(const FaceBounds& face) const
{
    if (!m_view) {
        return 1;
    }
    const glm::dvec3 p(m_view->toCamera * glm::dvec4(face.centre, 1));
    const double depth = -p.z;
    const double radius = face.radius;
    const glm::dvec2 outside =
        (glm::dvec2(std::abs(p.x), std::abs(p.y)) * m_view->focalLength - depth * m_reach) /
        m_planes;
    if (depth + radius < m_view->nearestDepth || std::max(outside.x, outside.y) > radius) {
        return 0;
    }
    // The ball may come nearer to the eye than the face does: the planes tell.
    const double above =
        std::abs(glm::dot(glm::dvec3(face.normal), m_eye - glm::dvec3(face.centre))) -
        double{face.height};
    const double nearest =
        std::max({depth - radius, above * m_view->focalLength / m_corner, m_view->nearestDepth});
    return m_corner / nearest;
}

} // namespace trixel
