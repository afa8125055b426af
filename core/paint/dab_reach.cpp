// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/paint/dab_reach.h"

#include <algorithm>
#include <glm/geometric.hpp>

namespace trixel {

namespace {

/// Cosine below which a face counts as facing away: a dab still goes round a sharp convex edge.
constexpr float kFacesAway = -0.2F;

std::vector<FaceId> sorted(std::vector<FaceId> faces)
{
    std::ranges::sort(faces);
    return faces;
}

} // namespace

DabReach::DabReach(std::shared_ptr<const Surface> surface, bool paintThrough)
    : m_surface(std::move(surface))
    , m_paintThrough(paintThrough)
    , m_flipped(sorted(m_surface->report().flippedFaces))
    , m_facesNoWay(m_surface->report().degenerateFaces)
{
    const std::vector<FaceId>& duplicates = m_surface->report().duplicateFaces;
    m_facesNoWay.insert(m_facesNoWay.end(), duplicates.begin(), duplicates.end());
    std::ranges::sort(m_facesNoWay);
}

glm::vec3 DabReach::normalOf(FaceId face) const
{
    if (std::ranges::binary_search(m_facesNoWay, face)) {
        return glm::vec3(0);
    }
    const auto [a, b, c] = m_surface->mesh().corners(face);
    const glm::dvec3 origin(a);
    const glm::dvec3 normal = glm::cross(glm::dvec3(b) - origin, glm::dvec3(c) - origin);
    const double length = glm::length(normal);
    if (!(length > 0)) {
        return glm::vec3(0);
    }
    const bool flipped = std::ranges::binary_search(m_flipped, face);
    return glm::vec3(normal / (flipped ? -length : length));
}

void DabReach::facesOf(const Dab& dab, std::vector<FaceId>& faces) const
{
    faces.clear();
    // A little more than the radius: a centroid on the rim is never lost to rounding.
    m_surface->bvh().facesWithin(dab.centre, dab.radius * 1.00001F, faces);
    if (m_paintThrough || dab.normal == glm::vec3(0)) {
        return;
    }
    std::erase_if(faces,
                  [&](FaceId face) { return glm::dot(normalOf(face), dab.normal) < kFacesAway; });
}

} // namespace trixel
