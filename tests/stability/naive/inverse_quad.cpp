// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/stability/naive_forms.h"

namespace trixel {

std::optional<glm::dvec2> inverseBilinear(const Quad& quad, glm::dvec2 point)
{
    return naive::inverseBilinear(quad, point);
}

} // namespace trixel
