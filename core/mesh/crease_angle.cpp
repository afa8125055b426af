// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/crease_angle.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <utility>

namespace trixel {

namespace {

/// As long as twice the area; zero where there is none.
glm::dvec3 normalOf(const std::array<glm::vec3, 3>& corners)
{
    const glm::dvec3 origin(corners[0]);
    return glm::cross(glm::dvec3(corners[1]) - origin, glm::dvec3(corners[2]) - origin);
}

/// Radians in [0, π]; also right next to its ends, where a cosine says nothing. Zero where either
/// has no length.
double angleBetween(glm::dvec3 a, glm::dvec3 b)
{
    return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
}

std::pair<std::uint32_t, std::uint32_t> endsOf(const Crease& crease)
{
    return {std::min(crease.from, crease.to), std::max(crease.from, crease.to)};
}

} // namespace

std::vector<Crease> creasesByAngle(const Surface& surface, double degrees)
{
    const double least = degrees * std::numbers::pi / 180;
    const TriangleMesh& mesh = surface.mesh();
    std::vector<Crease> creases;
    for (std::size_t f = 0; f < mesh.faceCount(); ++f) {
        for (std::uint8_t e = 0; e < 3; ++e) {
            const auto other = surface.adjacency().neighbour(faceId(f), static_cast<LocalEdge>(e));
            if (!other || indexOf(other->face) < f) {
                continue; // each edge once
            }
            const double fold = angleBetween(normalOf(mesh.corners(faceId(f))),
                                             normalOf(mesh.corners(other->face)));
            if (fold > least) {
                const Triangle& t = mesh.triangles[f];
                const auto [from, to] = std::minmax(t[e], t[(e + 1U) % 3]);
                creases.push_back({from, to, kSharp});
            }
        }
    }
    std::ranges::sort(creases, {}, endsOf);
    return creases;
}

Sharpness sharpnessOf(const Surface& surface, CreaseAngle angle)
{
    Sharpness sharpness = surface.mesh().sharpness;
    if (!angle) {
        return sharpness;
    }
    std::vector<Crease> own = std::move(sharpness.creases);
    std::ranges::sort(own, {}, endsOf);
    sharpness.creases = own;
    for (const Crease& crease : creasesByAngle(surface, double{*angle})) {
        if (!std::ranges::binary_search(own, endsOf(crease), {}, endsOf)) {
            sharpness.creases.push_back(crease);
        }
    }
    return sharpness;
}

} // namespace trixel
