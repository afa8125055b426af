// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/footprint/svd2.h"
#include "core/mapping/sphere.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

namespace trixel {

namespace {

double largestComponent(const glm::dvec3& v)
{
    return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
}

bool isFinite(const glm::dvec3& v)
{
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

/// (x,y) scaled down to length `longest`; no square of theirs overflows.
glm::dvec2 withinLength(glm::dvec2 v, double longest)
{
    const double length = std::hypot(v.x, v.y);
    if (!std::isfinite(length)) {
        return {longest, 0};
    }
    return length > longest ? v * (longest / length) : v;
}

/// Change of longitude and latitude, in radians, for a change of a direction.
struct SphereDerivative
{
    glm::dvec3 d;      ///< the direction, its largest component 1
    double axis = 0;   ///< distance from the axis
    double radius = 0; ///< length of d

    glm::dvec2 operator()(const glm::dvec3& change) const
    {
        // Along the parallel and along the meridian, as lengths; at the pole itself every way out
        // is along a meridian.
        const double around =
            axis > 0 ? differenceOfProducts(d.x, change.z, d.z, change.x) / axis : 0;
        const double outwards = axis > 0
                                    ? differenceOfProducts(d.x, change.x, -d.z, change.z) / axis
                                    : std::hypot(change.x, change.z);
        const double up = differenceOfProducts(axis, change.y, d.y, outwards) / radius;
        return {axis > 0 ? around / axis : INFINITY, up / radius};
    }
};

} // namespace

Footprint sphereFootprint(glm::dvec3 direction, glm::dvec3 perA, glm::dvec3 perB)
{
    const double largest = largestComponent(direction);
    if (!(largest > 0) || !isFinite(direction) || !isFinite(perA) || !isFinite(perB)) {
        return {{1, 0}, {0, 1}};
    }
    const glm::dvec3 d = direction / largest;
    const SphereDerivative derivative{d, std::hypot(d.x, d.z), glm::length(d)};
    const glm::dvec2 a = derivative(perA / largest);
    const glm::dvec2 b = derivative(perB / largest);
    const glm::dvec2 u = withinLength(glm::dvec2(a.x, b.x) / (2 * std::numbers::pi), 1);
    const glm::dvec2 v = withinLength(glm::dvec2(a.y, b.y) / std::numbers::pi, 1);
    return {{u.x, v.x}, {u.y, v.y}};
}

} // namespace trixel
