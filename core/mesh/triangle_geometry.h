// SPDX-License-Identifier: GPL-3.0-or-later
//
// One triangle against a point or a ray, in double precision and without special cases for
// triangles that are needles or points.
#pragma once

#include <array>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>

namespace trixel {

/// Point of a triangle nearest to another point.
struct NearestOnTriangle
{
    glm::dvec2 uv{0};           ///< u, v >= 0 and u + v <= 1
    double distanceSquared = 0; ///< world units squared
};

/// Nearest point of the triangle, which may have no area (a segment) or no extent (a point).
NearestOnTriangle nearestOnTriangle(const std::array<glm::vec3, 3>& corners, glm::dvec3 position);

/// Whether the triangle has no area: a repeated corner or three corners on one line.
bool isDegenerate(const std::array<glm::vec3, 3>& corners);

/// Mean of the squares of the three edge lengths, world units squared. Its root is the length that
/// densities of texels are counted along: a long thin face counts as long.
double meanSquareEdge(const std::array<glm::vec3, 3>& corners);

/// A ray prepared for many triangles: sheared so that it runs along one axis from its origin.
/// Two triangles that share an edge evaluate it to exactly opposite numbers, so that no ray slips
/// between them. Source: Woop, Benthin, Wald, "Watertight Ray/Triangle Intersection", JCGT 2013.
class RayShear
{
public:
    /// \param direction  finite and not zero
    RayShear(glm::dvec3 origin, glm::dvec3 direction);

    struct Hit
    {
        double t = 0; ///< in lengths of the direction, >= 0
        glm::dvec2 uv{0};
    };

    /// Where the ray meets the triangle, from either side; nothing for a degenerate triangle.
    std::optional<Hit> meet(const std::array<glm::vec3, 3>& corners) const;

private:
    glm::dvec3 sheared(glm::vec3 corner) const;

    glm::dvec3 m_origin;
    glm::dvec3 m_shear{0};
    int m_x = 0;
    int m_y = 1;
    int m_z = 2;
};

/// The nearest floats to (u,v) that still satisfy u, v >= 0 and u + v <= 1.
glm::vec2 insideTriangle(glm::dvec2 uv);

} // namespace trixel
