// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/footprint/screen_derivatives.h"

#include "core/footprint/limit.h"
#include "core/footprint/svd2.h"

#include <algorithm>
#include <cmath>

namespace trixel {

Footprint footprintOf(const ScreenDerivatives& d, double maxLength)
{
    const double limit = usableLimit(maxLength);
    const double largest =
        std::max({std::abs(d.perU.x), std::abs(d.perU.y), std::abs(d.perV.x), std::abs(d.perV.y)});
    if (!std::isfinite(d.perU.x + d.perU.y + d.perV.x + d.perV.y) || !(largest > 0)) {
        return roundFootprint(limit);
    }
    // In units of the largest derivative no product overflows, and none vanishes but beside it.
    const glm::dvec2 u = d.perU / largest;
    const glm::dvec2 v = d.perV / largest;
    const double det = differenceOfProducts(u.x, v.y, v.x, u.y);
    const Svd2 svd = svd2(u, v, det);
    const double shorter = std::min(1 / svd.major / largest, limit);
    const double longer = svd.minor > 0 ? std::min(1 / svd.minor / largest, limit) : limit;
    if (longer < limit) {
        const double scale = 1 / det;
        return {{v.y * scale / largest, -u.y * scale / largest},
                {-v.x * scale / largest, u.x * scale / largest}};
    }
    return inverseWithLengths(svd, shorter, longer);
}

} // namespace trixel
