// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/footprint/limit.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace trixel {

glm::dvec2 limitedVector(glm::dvec2 w, double longest)
{
    const double largest = std::max(std::abs(w.x), std::abs(w.y));
    if (largest <= longest / 2 || !std::isfinite(w.x) || !std::isfinite(w.y)) {
        return w; // at most √2 times its larger component
    }
    const glm::dvec2 unit = w / largest;
    const double length = largest * glm::length(unit); // may be infinite, which is longer too
    return length > longest ? unit * (longest / glm::length(unit)) : w;
}

} // namespace trixel
