// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/views/camera_clip.h"

#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <numbers>

namespace trixel {

glm::dmat4 toClip(const ViewCamera& camera)
{
    const glm::dvec3 forward = camera.forward();
    const glm::dvec3 right = glm::normalize(glm::cross(forward, camera.up));
    const glm::dvec3 up = glm::cross(right, forward);
    const double height = std::tan(0.5 * camera.fovY * std::numbers::pi / 180);
    const double width = height * camera.width / camera.height;
    // Rows of a matrix: across, up, depth (in front of -1 near by), distance.
    const std::array<glm::dvec4, 4> rows = {
        glm::dvec4(right / width, -glm::dot(right, camera.position) / width),
        glm::dvec4(up / height, -glm::dot(up, camera.position) / height),
        glm::dvec4(forward, -glm::dot(forward, camera.position) - 1),
        glm::dvec4(forward, -glm::dot(forward, camera.position))};
    return glm::transpose(glm::dmat4(rows[0], rows[1], rows[2], rows[3]));
}

} // namespace trixel
