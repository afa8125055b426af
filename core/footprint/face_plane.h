// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace trixel {

inline bool isFinite(glm::dvec2 v)
{
    return std::isfinite(v.x) && std::isfinite(v.y);
}

inline bool isFinite(const glm::dvec3& v)
{
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

inline double largestComponent(glm::dvec2 v)
{
    return std::max(std::abs(v.x), std::abs(v.y));
}

inline double largestComponent(const glm::dvec3& v)
{
    return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
}

/// A face in units of its longest edge's larger component, so that no product overflows.
struct FacePlane
{
    glm::dvec3 origin{0};
    glm::dvec3 e1{0};     ///< V1 - V0
    glm::dvec3 e2{0};     ///< V2 - V0
    glm::dvec3 normal{0}; ///< e1 × e2, not of unit length
    double scale = 0;     ///< world units of one unit here

    explicit FacePlane(const std::array<glm::vec3, 3>& corners)
        : origin(corners[0])
        , e1(glm::dvec3(corners[1]) - origin)
        , e2(glm::dvec3(corners[2]) - origin)
        , scale(std::max(largestComponent(e1), largestComponent(e2)))
    {
        if (scale > 0 && std::isfinite(scale)) {
            e1 /= scale;
            e2 /= scale;
            normal = glm::cross(e1, e2);
        }
    }

    /// Zero area, as far as the numbers tell.
    bool isDegenerate() const
    {
        constexpr double kRounding = 1e-15;
        return !(glm::length(normal) > kRounding * glm::length(e1) * glm::length(e2));
    }
};

} // namespace trixel
