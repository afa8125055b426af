// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mapping/quad.h"

namespace trixel {

glm::dvec2 bilinear(const Quad& q, glm::dvec2 uv)
{
    return q.p00 + uv.x * (q.p10 - q.p00) + uv.y * (q.p01 - q.p00) +
           uv.x * uv.y * (q.p11 - q.p01 - q.p10 + q.p00);
}

} // namespace trixel
