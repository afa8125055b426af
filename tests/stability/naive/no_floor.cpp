// SPDX-License-Identifier: GPL-3.0-or-later
//
// The covariance of W alone: no floor of a quarter of a texel's square.
#include "core/footprint/covariance.h"
#include "core/footprint/svd2.h"

#include <glm/geometric.hpp>

namespace trixel {

Covariance covarianceOf(glm::dvec2 half1, glm::dvec2 half2, double /*floor*/)
{
    const double cross = differenceOfProducts(half1.x, half2.y, half1.y, half2.x);
    return {half1.x * half1.x + half2.x * half2.x,
            half1.x * half1.y + half2.x * half2.y,
            half1.y * half1.y + half2.y * half2.y,
            cross * cross};
}

} // namespace trixel
