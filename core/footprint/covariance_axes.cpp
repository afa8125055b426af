// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/footprint/covariance.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace trixel {

CovarianceAxes axesOf(const Covariance& c)
{
    // Half the difference of the eigenvalues, doubled twice over: λ± = (xx + yy ± spread) / 2.
    const double difference = c.xx - c.yy;
    const double spread = std::sqrt(difference * difference + 4 * c.xy * c.xy);
    const double major = (c.xx + c.yy + spread) / 2;
    CovarianceAxes axes;
    axes.majorSigma = std::sqrt(major);
    axes.minorSigma = major > 0 ? std::sqrt(std::min(c.determinant / major, major)) : 0;
    // Both columns of Σ - λ_minor are multiples of the direction; in the longer one nothing is
    // subtracted.
    const glm::dvec2 column = difference >= 0 ? glm::dvec2(difference + spread, 2 * c.xy)
                                              : glm::dvec2(2 * c.xy, spread - difference);
    const double length = glm::length(column);
    if (length > 0) {
        axes.majorAxis = column / length;
    }
    return axes;
}

} // namespace trixel
