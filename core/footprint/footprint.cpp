// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/footprint/footprint.h"

#include "core/footprint/limit.h"
#include "core/footprint/svd2.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace trixel {

namespace {

/// Longest W that `ellipseOf` takes as it is; far beyond any filter, far from overflow.
constexpr double kWidest = 1 << 20;

bool isFinite(glm::dvec2 v)
{
    return std::isfinite(v.x) && std::isfinite(v.y);
}

bool isFinite(const glm::dvec3& v)
{
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

double largestComponent(glm::dvec2 v)
{
    return std::max(std::abs(v.x), std::abs(v.y));
}

double largestComponent(const glm::dvec3& v)
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

FootprintEllipse ellipseOf(const Footprint& footprint, const std::array<glm::vec3, 3>& corners)
{
    const FacePlane plane(corners);
    if (!(plane.scale > 0) || !isFinite(plane.e1) || !isFinite(plane.e2)) {
        return {};
    }
    Footprint w = footprint;
    if (!isFinite(w.w1) || !isFinite(w.w2)) {
        w = roundFootprint(kWidest);
    }
    const double longest = std::max(largestComponent(w.w1), largestComponent(w.w2));
    if (longest > kWidest) {
        w.w1 *= kWidest / longest;
        w.w2 *= kWidest / longest;
    }
    // Plane frame: x along e1 (or e2 when V0 and V1 coincide), y across it within the face.
    const bool alongFirst = glm::length(plane.e1) > 0;
    const glm::dvec3 x = glm::normalize(alongFirst ? plane.e1 : plane.e2);
    const double area = glm::length(plane.normal);
    const glm::dvec2 t1(glm::dot(plane.e1, x), 0);
    const glm::dvec2 t2(glm::dot(plane.e2, x), t1.x > 0 ? area / t1.x : 0);

    // Half axes are the singular values of ½ T [W1 W2]: the square roots of the eigenvalues of
    // ¼ T (W1 W1ᵀ + W2 W2ᵀ) Tᵀ, without squaring and subtracting.
    const glm::dvec2 p1 = (t1 * w.w1.x + t2 * w.w1.y) / 2.0;
    const glm::dvec2 p2 = (t1 * w.w2.x + t2 * w.w2.y) / 2.0;
    const double det = t1.x * t2.y / 4 * differenceOfProducts(w.w1.x, w.w2.y, w.w2.x, w.w1.y);
    const Svd2 svd = svd2(p1, p2, det);

    FootprintEllipse ellipse;
    ellipse.majorLength = svd.major * plane.scale;
    ellipse.minorLength = svd.minor * plane.scale;
    ellipse.major = (w.w1 * svd.majorFrom.x + w.w2 * svd.majorFrom.y) / 2.0;
    // W v would lose the minor axis of a long ellipse to rounding; T is known and triangular.
    const glm::dvec2 minor = svd.minor * svd.minorTo;
    if (t2.y > 0) {
        const double v = minor.y / t2.y;
        ellipse.minor = {(minor.x - t2.x * v) / t1.x, v};
    }
    return ellipse;
}

} // namespace trixel
