// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/footprint/screen_derivatives.h"

namespace trixel {

Footprint footprintOf(const ScreenDerivatives& derivatives, double /*maxLength*/)
{
    return inverseJacobian(derivatives);
}

} // namespace trixel
