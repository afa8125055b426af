// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/footprint/face_plane.h"
#include "core/footprint/limit.h"
#include "core/footprint/projected_face.h"
#include "core/footprint/svd2.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace trixel {

namespace {

/// w² times the derivative of (x/w, y/w).
glm::dvec2 scaledDerivative(const glm::dvec3& p, const glm::dvec3& d)
{
    return {differenceOfProducts(d.x, p.z, p.x, d.z), differenceOfProducts(d.y, p.z, p.y, d.z)};
}

} // namespace

std::optional<Footprint>
footprintOf(const ProjectedFace& face, glm::dvec2 uv, double maxLength, double nearW)
{
    const glm::dvec3 point = face.at(uv);
    if (!(point.z > std::max(nearW, 0.0))) {
        return std::nullopt;
    }
    const double limit = usableLimit(maxLength);
    const double size = largestComponent(point);
    const double change = std::max(largestComponent(face.perU), largestComponent(face.perV));
    if (!std::isfinite(size) || !std::isfinite(change)) {
        return roundFootprint(limit);
    }
    if (!(change > 0)) {
        return roundFootprint(limit); // the face is a point: a pixel covers all of it
    }
    // Homogeneous coordinates have a free scale: one for the point, one for its changes.
    const glm::dvec3 p = point / size;
    const glm::dvec3 u = face.perU / change;
    const glm::dvec3 v = face.perV / change;
    const double perUv = size / change; // footprints here are in changes of `p`
    const glm::dvec2 a1 = scaledDerivative(p, u);
    const glm::dvec2 a2 = scaledDerivative(p, v);
    const double volume = glm::dot(p, glm::cross(u, v));
    const Svd2 svd = svd2(a1, a2, p.z * volume);
    if (!(svd.major > 0)) {
        return roundFootprint(limit);
    }
    const double shorter = std::min(p.z * (p.z / svd.major) * perUv, limit);
    const double longer = p.z * (svd.major / std::abs(volume)) * perUv; // inf where volume is 0
    if (longer < limit) {
        const double k = p.z / volume * perUv;
        return Footprint{{k * a2.y, -k * a1.y}, {-k * a2.x, k * a1.x}};
    }
    return inverseWithLengths(svd, shorter, limit);
}

} // namespace trixel
