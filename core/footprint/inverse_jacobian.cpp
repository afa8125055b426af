// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/footprint/screen_derivatives.h"

namespace trixel {

Footprint inverseJacobian(const ScreenDerivatives& d)
{
    const double det = d.perU.x * d.perV.y - d.perV.x * d.perU.y;
    return {{d.perV.y / det, -d.perU.y / det}, {-d.perV.x / det, d.perU.x / det}};
}

} // namespace trixel
