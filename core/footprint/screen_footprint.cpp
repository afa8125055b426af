// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/footprint/face_plane.h"
#include "core/footprint/footprint.h"
#include "core/footprint/limit.h"
#include "core/footprint/svd2.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace trixel {

namespace {

/// A ray relative to the face's frame; direction and its changes share one free scale.
struct ScaledRay
{
    glm::dvec3 offset; ///< origin minus V0
    glm::dvec3 direction;
    glm::dvec3 perX;
    glm::dvec3 perY;
};

ScaledRay scaledTo(const FacePlane& plane, const PixelRay& ray)
{
    const double length = std::max(
        {largestComponent(ray.direction), largestComponent(ray.perX), largestComponent(ray.perY)});
    return {ray.origin / plane.scale - plane.origin / plane.scale,
            ray.direction / length,
            ray.perX / length,
            ray.perY / length};
}

} // namespace

// With s = origin - V0, D the direction and n = e1 × e2, the ray meets the plane at
//   u = D·(e2 × s) / D·(e2 × e1),  v = D·(s × e1) / D·(e2 × e1),  t = -(s·n) / (D·n).
// Differentiating these quotients and applying Lagrange's identity leaves products only:
//   d(u,v) = (s·n) / (D·n)² · ((dD × D)·e2, -(dD × D)·e1).
// So the footprint is k A with k = (s·n)/(D·n)² and A always finite, det A = (D·n)(D·(dDx × dDy)).
// Nothing is inverted: at a silhouette (D·n → 0) the singular values of k A grow without bound
// along known directions, and are limited there.
Footprint
screenFootprint(const PixelRay& ray, const std::array<glm::vec3, 3>& corners, double maxLength)
{
    const double limit = usableLimit(maxLength);
    const FacePlane plane(corners);
    if (!std::isfinite(plane.scale)) {
        return roundFootprint(limit);
    }
    if (plane.isDegenerate()) {
        return {};
    }
    const ScaledRay r = scaledTo(plane, ray);
    if (!isFinite(r.offset) || !isFinite(r.direction) || !isFinite(r.perX) || !isFinite(r.perY)) {
        return roundFootprint(limit);
    }
    const double height = glm::dot(r.offset, plane.normal);
    const double slope = glm::dot(r.direction, plane.normal);
    const double distance = -height / slope; // along the ray, in directions
    if (!(distance > 0) || !std::isfinite(distance)) {
        return roundFootprint(limit); // at or beyond the horizon
    }
    const glm::dvec3 crossX = glm::cross(r.perX, r.direction);
    const glm::dvec3 crossY = glm::cross(r.perY, r.direction);
    const glm::dvec2 a1(glm::dot(crossX, plane.e2), -glm::dot(crossX, plane.e1));
    const glm::dvec2 a2(glm::dot(crossY, plane.e2), -glm::dot(crossY, plane.e1));
    const double volume = glm::dot(r.direction, glm::cross(r.perX, r.perY));
    const Svd2 svd = svd2(a1, a2, slope * volume);
    if (!(svd.major > 0)) {
        return {}; // the ray does not change from pixel to pixel
    }
    // k = -distance / slope. The determinant of A holds one slope, which cancels in the minor.
    const double major = distance / std::abs(slope) * svd.major;
    const double minor = distance * std::abs(volume) / svd.major;
    if (major <= limit) {
        const double k = -distance / slope;
        return {k * a1, k * a2};
    }
    const double side = slope < 0 ? 1 : -1;
    const double cut = std::min(minor, limit);
    return withLengths(svd, side * limit, side * (std::isfinite(cut) ? cut : limit));
}

} // namespace trixel
