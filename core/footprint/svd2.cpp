// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/footprint/svd2.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace trixel {

namespace {

double largestComponent(glm::dvec2 a, glm::dvec2 b)
{
    return std::max({std::abs(a.x), std::abs(a.y), std::abs(b.x), std::abs(b.y)});
}

/// For columns whose largest component is about 1.
Svd2 svdOfScaled(glm::dvec2 c1, glm::dvec2 c2, double det)
{
    // The matrix is the sum of a scaled rotation (p, r) and a scaled reflection (q, s); half the
    // sum and half the difference of their angles turn it into a diagonal one. atan2 is defined
    // for the circle, where the reflection vanishes.
    const double p = (c1.x + c2.y) / 2;
    const double q = (c1.x - c2.y) / 2;
    const double r = (c1.y - c2.x) / 2;
    const double s = (c1.y + c2.x) / 2;
    const double rotation = std::atan2(r, p);
    const double reflection = std::atan2(s, q);
    const double to = (reflection + rotation) / 2;
    const double from = (reflection - rotation) / 2;

    Svd2 svd;
    svd.major = std::hypot(p, r) + std::hypot(q, s);
    svd.minor = svd.major > 0 ? std::min(std::abs(det) / svd.major, svd.major) : 0;
    const double side = det < 0 ? -1 : 1;
    svd.majorTo = {std::cos(to), std::sin(to)};
    svd.minorTo = side * glm::dvec2(-svd.majorTo.y, svd.majorTo.x);
    svd.majorFrom = {std::cos(from), std::sin(from)};
    svd.minorFrom = {-svd.majorFrom.y, svd.majorFrom.x};
    return svd;
}

} // namespace

double differenceOfProducts(double a, double d, double b, double c)
{
    const double bc = b * c;
    const double error = std::fma(-b, c, bc);
    return std::fma(a, d, -bc) + error;
}

Svd2 svd2(glm::dvec2 c1, glm::dvec2 c2)
{
    const double scale = largestComponent(c1, c2);
    if (!(scale > 0)) {
        return {};
    }
    const glm::dvec2 a = c1 / scale;
    const glm::dvec2 b = c2 / scale;
    Svd2 svd = svdOfScaled(a, b, differenceOfProducts(a.x, b.y, b.x, a.y));
    svd.major *= scale;
    svd.minor *= scale;
    return svd;
}

Svd2 svd2(glm::dvec2 c1, glm::dvec2 c2, double det)
{
    const double scale = largestComponent(c1, c2);
    if (!(scale > 0)) {
        return {};
    }
    Svd2 svd = svdOfScaled(c1 / scale, c2 / scale, det / scale / scale);
    svd.major *= scale;
    svd.minor *= scale;
    return svd;
}

} // namespace trixel
