// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/footprint/covariance.h"

#include "core/footprint/svd2.h"

#include <glm/geometric.hpp>

namespace trixel {

Covariance covarianceOf(glm::dvec2 half1, glm::dvec2 half2, double floor)
{
    const double trace = glm::dot(half1, half1) + glm::dot(half2, half2);
    const double cross = differenceOfProducts(half1.x, half2.y, half1.y, half2.x);
    return {half1.x * half1.x + half2.x * half2.x + floor,
            half1.x * half1.y + half2.x * half2.y,
            half1.y * half1.y + half2.y * half2.y + floor,
            cross * cross + floor * trace + floor * floor};
}

} // namespace trixel
