// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/footprint/limit.h"

#include "core/footprint/face_plane.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace trixel {

Footprint roundFootprint(double width)
{
    return {{width, 0}, {0, width}};
}

Footprint limitedTo(const Footprint& footprint, double maxLength)
{
    const double limit = usableLimit(maxLength);
    if (!isFinite(footprint.w1) || !isFinite(footprint.w2)) {
        return roundFootprint(limit);
    }
    const Svd2 svd = svd2(footprint.w1, footprint.w2);
    if (svd.major <= limit) {
        return footprint;
    }
    return withLengths(svd, limit, std::min(svd.minor, limit));
}

Footprint withLengths(const Svd2& svd, double longer, double shorter)
{
    const glm::dvec2 a = longer * svd.majorTo;
    const glm::dvec2 b = shorter * svd.minorTo;
    return {a * svd.majorFrom.x + b * svd.minorFrom.x, a * svd.majorFrom.y + b * svd.minorFrom.y};
}

Footprint inverseWithLengths(const Svd2& svd, double shorter, double longer)
{
    const glm::dvec2 a = shorter * svd.majorFrom;
    const glm::dvec2 b = longer * svd.minorFrom;
    return {a * svd.majorTo.x + b * svd.minorTo.x, a * svd.majorTo.y + b * svd.minorTo.y};
}

double usableLimit(double maxLength)
{
    constexpr double kWidest = 1 << 20;
    return std::isfinite(maxLength) ? std::clamp(maxLength, 0.0, kWidest) : kWidest;
}

} // namespace trixel
