// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/stability/naive_forms.h"

namespace trixel {

Footprint sphereFootprint(glm::dvec3 direction, glm::dvec3 perA, glm::dvec3 perB)
{
    return naive::sphereDifferences(direction, perA, perB);
}

} // namespace trixel
