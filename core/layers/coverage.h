// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace trixel {

/// The coverage that a stored number stands for: within [0,1], NaN is none. A plain choice between
/// values, so that loops over it run several at a time.
inline float coverageOf(float stored)
{
    const float positive = stored > 0.0F ? stored : 0.0F; // false for NaN
    return positive < 1.0F ? positive : 1.0F;
}

} // namespace trixel
