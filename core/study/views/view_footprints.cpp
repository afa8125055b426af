// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/views/view_footprints.h"

#include <glm/geometric.hpp>
#include <utility>

namespace trixel {

namespace {

/// What is nearer by more than rounding stands in front.
constexpr double kSamePlace = 1e-4;

std::optional<Footprint>
footprintAt(const Surface& surface, const ViewCamera& camera, FaceId face, glm::dvec2 uv)
{
    const auto corners = surface.mesh().corners(face);
    const glm::dvec3 a(corners[0]);
    const glm::dvec3 point =
        a + uv.x * (glm::dvec3(corners[1]) - a) + uv.y * (glm::dvec3(corners[2]) - a);
    if (!camera.frames(point)) {
        return std::nullopt;
    }
    const glm::dvec2 place = *camera.project(point);
    const PixelRay ray = camera.pixelRay(place.x, place.y);
    const auto seen = surface.bvh().raycast({glm::vec3(ray.origin), glm::vec3(ray.direction)});
    const double distance = glm::length(point - camera.position);
    if (seen &&
        glm::length(glm::dvec3(seen->position) - camera.position) < distance * (1 - kSamePlace)) {
        return std::nullopt;
    }
    return screenFootprint(ray, corners);
}

} // namespace

FootprintAt footprintsOf(std::shared_ptr<const Surface> surface, const ViewCamera& camera)
{
    return [surface = std::move(surface), camera](FaceId face, glm::dvec2 uv) {
        return footprintAt(*surface, camera, face, uv);
    };
}

} // namespace trixel
