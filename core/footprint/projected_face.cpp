// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/footprint/projected_face.h"

#include <glm/vec4.hpp>

namespace trixel {

ProjectedFace projectedFace(const glm::dmat4& toPixels, const std::array<glm::vec3, 3>& corners)
{
    const auto homogeneous = [&](const glm::dvec3& p, double w) {
        const glm::dvec4 q = toPixels * glm::dvec4(p, w);
        return glm::dvec3(q.x, q.y, q.w);
    };
    const glm::dvec3 v0(corners[0]);
    // Edges are mapped as directions: differences of mapped corners would lose digits far away.
    return {homogeneous(v0, 1),
            homogeneous(glm::dvec3(corners[1]) - v0, 0),
            homogeneous(glm::dvec3(corners[2]) - v0, 0)};
}

ScreenDerivatives screenDerivatives(const ProjectedFace& face, glm::dvec2 uv)
{
    const glm::dvec3 p = face.at(uv);
    const auto derivative = [&](const glm::dvec3& d) {
        return glm::dvec2(d.x * p.z - p.x * d.z, d.y * p.z - p.y * d.z) / (p.z * p.z);
    };
    return {derivative(face.perU), derivative(face.perV)};
}

} // namespace trixel
