// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/footprint/sources.h"

#include <cmath>

namespace trixel {

namespace {

glm::dvec2 uvOfEquilateral(glm::dvec2 plane)
{
    const double v = plane.y * 2 / std::sqrt(3.0);
    return {plane.x - v / 2, v};
}

} // namespace

Footprint textureAligned(double uw, double vw)
{
    return {{uw, 0}, {0, vw}};
}

Footprint fromHalfAxes(glm::dvec2 first, glm::dvec2 second)
{
    return {2.0 * first, 2.0 * second};
}

Footprint equilateralFootprint(double width, double anisotropy, double angle)
{
    const glm::dvec2 along(std::cos(angle), std::sin(angle));
    const glm::dvec2 across(-along.y, along.x);
    return {uvOfEquilateral(width * anisotropy * along), uvOfEquilateral(width * across)};
}

} // namespace trixel
