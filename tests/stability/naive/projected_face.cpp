// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/stability/naive_forms.h"

namespace trixel {

std::optional<Footprint>
footprintOf(const ProjectedFace& face, glm::dvec2 uv, double /*maxLength*/, double /*nearW*/)
{
    return naive::footprintOf(face, uv);
}

} // namespace trixel
