// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/filter/filter_surface.h"
#include "core/mesh/triangle_geometry.h"

#include <algorithm>
#include <glm/geometric.hpp>

namespace trixel {
namespace {

FaceShape equilateralShape(double edge)
{
    const FaceShape unit;
    return {edge * unit.e1, edge * unit.e2};
}

} // namespace

FaceShape faceShapeOf(const std::array<glm::vec3, 3>& corners)
{
    const glm::dvec3 a(corners[0]);
    const glm::dvec3 e1 = glm::dvec3(corners[1]) - a;
    const glm::dvec3 e2 = glm::dvec3(corners[2]) - a;
    const double length = glm::length(e1);
    const double area = glm::length(glm::cross(e1, e2));
    const double longest = std::max({length, glm::length(e2), glm::length(e2 - e1)});
    // Below this height the plane's inverse would be rounding noise.
    constexpr double kFlattest = 1e-9;
    if (isDegenerate(corners) || !(area > kFlattest * longest * longest) || !(length > 0)) {
        return equilateralShape(longest > 0 ? longest : 1.0);
    }
    return {{length, 0}, {glm::dot(e1, e2) / length, area / length}};
}

} // namespace trixel
