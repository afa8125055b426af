// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/paint/dab_reach.h"

#include <algorithm>
#include <glm/geometric.hpp>

namespace trixel {

namespace {

std::vector<FaceId> sorted(std::vector<FaceId> faces)
{
    std::ranges::sort(faces);
    return faces;
}

} // namespace

DabReach::DabReach(std::shared_ptr<const Surface> surface,
                   bool paintThrough,
                   std::shared_ptr<const LimitMesh> limit)
    : m_surface(std::move(surface))
    , m_limit(std::move(limit))
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

glm::vec3 DabReach::turned(FaceId face, glm::vec3 normal) const
{
    if (std::ranges::binary_search(m_facesNoWay, face)) {
        return glm::vec3(0);
    }
    return std::ranges::binary_search(m_flipped, face) ? -normal : normal;
}

void DabReach::facesOf(const Dab& dab, std::vector<FaceId>& faces) const
{
    faces.clear();
    // A little more than the radius: a centroid on the rim is never lost to rounding.
    const float radius = dab.radius * 1.00001F;
    if (m_limit) { // whose triangles are off it
        const auto off = static_cast<float>(m_limit->tessellation().error());
        m_limit->facesWithin(dab.centre, radius + off, faces);
    } else {
        m_surface->bvh().facesWithin(dab.centre, radius, faces);
    }
    if (m_paintThrough || m_limit || dab.normal == glm::vec3(0)) {
        return;
    }
    std::erase_if(faces,
                  [&](FaceId face) { return glm::dot(normalOf(face), dab.normal) < kFacesAway; });
}

} // namespace trixel
