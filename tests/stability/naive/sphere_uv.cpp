// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/stability/naive_forms.h"

namespace trixel {

glm::dvec2 sphereUv(glm::dvec3 direction)
{
    return naive::sphereUv(direction);
}

} // namespace trixel
