// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/footprint/ellipse_report.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <numbers>

namespace trixel {

namespace {

/// Mean log2 of the edges that have a length.
double ownLog2Edge(const std::array<glm::vec3, 3>& corners)
{
    double sum = 0;
    int count = 0;
    for (std::size_t e = 0; e < 3; ++e) {
        const double length =
            glm::length(glm::dvec3(corners[(e + 1) % 3]) - glm::dvec3(corners[e]));
        if (length > 0 && std::isfinite(length)) {
            sum += std::log2(length);
            ++count;
        }
    }
    return count > 0 ? sum / count : 0;
}

double conditionOf(const FootprintEllipse& ellipse)
{
    if (ellipse.minorLength > 0) {
        return ellipse.majorLength / ellipse.minorLength;
    }
    return ellipse.majorLength > 0 ? std::numeric_limits<double>::infinity() : 1.0;
}

} // namespace

double levelForWidth(double width, double log2Edge, Level base)
{
    const double finest = base.log2();
    return width > 0 ? std::clamp(log2Edge - std::log2(width), 0.0, finest) : finest;
}

EllipseReport describe(const Footprint& footprint,
                       const std::array<glm::vec3, 3>& corners,
                       Level base,
                       double log2Edge)
{
    EllipseReport report;
    report.ellipse = ellipseOf(footprint, corners);
    const double width = 2 * report.ellipse.minorLength;
    report.area = std::numbers::pi * report.ellipse.majorLength * report.ellipse.minorLength;
    report.condition = conditionOf(report.ellipse);
    report.width = width * std::exp2(base.log2() - log2Edge);
    report.level = levelForWidth(width, log2Edge, base);
    return report;
}

EllipseReport
describe(const Footprint& footprint, const std::array<glm::vec3, 3>& corners, Level base)
{
    return describe(footprint, corners, base, ownLog2Edge(corners));
}

} // namespace trixel
