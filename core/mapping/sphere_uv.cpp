// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mapping/sphere.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace trixel {

glm::dvec2 sphereUv(glm::dvec3 direction)
{
    const double largest =
        std::max({std::abs(direction.x), std::abs(direction.y), std::abs(direction.z)});
    if (!(largest > 0) || !std::isfinite(direction.x + direction.y + direction.z)) {
        return {0.25, 0.5};
    }
    const glm::dvec3 d = direction / largest;
    const double longitude = std::atan2(d.z, d.x) / (2 * std::numbers::pi) + 0.25;
    const double latitude = std::atan2(d.y, std::hypot(d.x, d.z)) / std::numbers::pi;
    const double u = longitude - std::floor(longitude);
    return {u < 1 ? u : 0, std::clamp(latitude + 0.5, 0.0, 1.0)};
}

} // namespace trixel
