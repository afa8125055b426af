// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/lattice/paint_projection.h"

namespace trixel {

glm::dvec2 toPacked(Level level, TexelHalf half, glm::dvec2 uv, double offset)
{
    const double resolution = level.resolution();
    if (half == TexelHalf::Lower) {
        return uv * resolution + offset;
    }
    return glm::dvec2(resolution - uv.y * resolution, resolution - uv.x * resolution) + offset;
}

glm::dvec2 fromPacked(Level level, TexelHalf half, glm::dvec2 pixel, double offset)
{
    const double resolution = level.resolution();
    const glm::dvec2 moved = pixel - offset;
    if (half == TexelHalf::Lower) {
        return moved / resolution;
    }
    return glm::dvec2(resolution - moved.y, resolution - moved.x) / resolution;
}

} // namespace trixel
