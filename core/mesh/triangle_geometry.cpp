// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/triangle_geometry.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace trixel {

namespace {

/// Parameter in [0,1] of the point of the segment from a to a + d nearest to p (all from one
/// origin); 0 for a segment of no length.
double nearestOnSegment(glm::dvec3 toPoint, glm::dvec3 d)
{
    const double along = glm::dot(toPoint, d);
    const double length = glm::dot(d, d);
    if (!(along > 0)) {
        return 0;
    }
    return along < length ? along / length : 1;
}

} // namespace

NearestOnTriangle nearestOnTriangle(const std::array<glm::vec3, 3>& corners, glm::dvec3 position)
{
    // Relative to V0: large coordinates cancel before anything is multiplied.
    const glm::dvec3 p = position - glm::dvec3(corners[0]);
    const glm::dvec3 e1 = glm::dvec3(corners[1]) - glm::dvec3(corners[0]);
    const glm::dvec3 e2 = glm::dvec3(corners[2]) - glm::dvec3(corners[0]);
    const glm::dvec3 normal = glm::cross(e1, e2);
    const double area = glm::dot(normal, normal);
    NearestOnTriangle best{{0, 0}, glm::dot(p, p)};
    const auto consider = [&](glm::dvec2 uv) {
        const glm::dvec3 apart = p - uv.x * e1 - uv.y * e2;
        const double distance = glm::dot(apart, apart);
        if (distance < best.distanceSquared) {
            best = {uv, distance};
        }
    };
    if (area > 0) {
        const double u = glm::dot(glm::cross(p, e2), normal);
        const double v = glm::dot(glm::cross(e1, p), normal);
        if (u >= 0 && v >= 0 && u + v <= area) {
            consider({u / area, v / area});
            // The plane of a needle is uncertain: there the edges are asked as well.
            if (area > 1e-16 * glm::dot(e1, e1) * glm::dot(e2, e2)) {
                return best;
            }
        }
    }
    // Outside the prism over the triangle (or no such prism): the nearest of its three edges.
    const double t1 = nearestOnSegment(p - e1, e2 - e1);
    consider({nearestOnSegment(p, e1), 0});
    consider({1 - t1, t1});
    consider({0, nearestOnSegment(p, e2)});
    return best;
}

bool isDegenerate(const std::array<glm::vec3, 3>& corners)
{
    const glm::dvec3 e1 = glm::dvec3(corners[1]) - glm::dvec3(corners[0]);
    const glm::dvec3 e2 = glm::dvec3(corners[2]) - glm::dvec3(corners[0]);
    // Products of float differences are near enough to exact in double for a test against zero.
    return glm::cross(e1, e2) == glm::dvec3(0);
}

double meanSquareEdge(const std::array<glm::vec3, 3>& corners)
{
    double squares = 0;
    for (std::size_t k = 0; k < 3; ++k) {
        const glm::dvec3 edge = glm::dvec3(corners[(k + 1) % 3]) - glm::dvec3(corners[k]);
        squares += glm::dot(edge, edge);
    }
    return squares / 3;
}

RayShear::RayShear(glm::dvec3 origin, glm::dvec3 direction)
    : m_origin(origin)
{
    const glm::dvec3 size = glm::abs(direction);
    m_z = size.x > size.y ? (size.x > size.z ? 0 : 2) : (size.y > size.z ? 1 : 2);
    m_x = (m_z + 1) % 3;
    m_y = (m_x + 1) % 3;
    const double along = direction[m_z];
    m_shear = {direction[m_x] / along, direction[m_y] / along, 1.0 / along};
}

glm::dvec3 RayShear::sheared(glm::vec3 corner) const
{
    const glm::dvec3 d = glm::dvec3(corner) - m_origin;
    return {d[m_x] - m_shear.x * d[m_z], d[m_y] - m_shear.y * d[m_z], m_shear.z * d[m_z]};
}

std::optional<RayShear::Hit> RayShear::meet(const std::array<glm::vec3, 3>& corners) const
{
    const glm::dvec3 a = sheared(corners[0]);
    const glm::dvec3 b = sheared(corners[1]);
    const glm::dvec3 c = sheared(corners[2]);
    const double w0 = c.x * b.y - c.y * b.x;
    const double w1 = a.x * c.y - a.y * c.x;
    const double w2 = b.x * a.y - b.y * a.x;
    const bool negative = w0 < 0 || w1 < 0 || w2 < 0;
    const bool positive = w0 > 0 || w1 > 0 || w2 > 0;
    const double sum = w0 + w1 + w2;
    if ((negative && positive) || sum == 0 || isDegenerate(corners)) {
        return std::nullopt;
    }
    const double t = (w0 * a.z + w1 * b.z + w2 * c.z) / sum;
    if (!(t >= 0)) {
        return std::nullopt;
    }
    return Hit{t, {w1 / sum, w2 / sum}};
}

glm::vec2 insideTriangle(glm::dvec2 uv)
{
    const float u = std::clamp(static_cast<float>(uv.x), 0.0F, 1.0F);
    const float v = std::clamp(static_cast<float>(uv.y), 0.0F, 1.0F);
    return {u, u + v > 1.0F ? 1.0F - u : v};
}

} // namespace trixel
