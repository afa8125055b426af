// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/stability/naive_forms.h"

namespace trixel {

Covariance covarianceOf(glm::dvec2 half1, glm::dvec2 half2, double floor)
{
    return naive::covarianceOf(half1, half2, floor);
}

} // namespace trixel
