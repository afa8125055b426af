// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/texture/opacity.h"

namespace trixel {

/// The coverage that a stored number stands for, in [0,1]: the opacity of a layer's texel.
inline float coverageOf(float stored)
{
    return opacityOf(stored);
}

} // namespace trixel
