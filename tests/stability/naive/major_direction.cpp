// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/stability/naive_forms.h"

namespace trixel {

CovarianceAxes axesOf(const Covariance& covariance)
{
    return naive::directionByOneForm(covariance);
}

} // namespace trixel
