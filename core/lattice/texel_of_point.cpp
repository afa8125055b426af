// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/lattice/texel.h"

#include <algorithm>

namespace trixel {

namespace {

std::uint16_t narrow(std::uint32_t value)
{
    return static_cast<std::uint16_t>(value);
}

/// floor(x R) clamped to [0, R-1]; NaN gives 0.
std::uint32_t cellOf(double x, std::uint32_t resolution)
{
    const double scaled = x * resolution;
    if (!(scaled > 0.0)) {
        return 0;
    }
    // Clamped before the cast: a large double does not fit an integer.
    return static_cast<std::uint32_t>(std::min(scaled, static_cast<double>(resolution - 1)));
}

} // namespace

TexelCoord texelAt(Level level, glm::dvec2 uv)
{
    const std::uint32_t resolution = level.resolution();
    const std::uint32_t i = cellOf(uv.x, resolution);
    const std::uint32_t j = cellOf(uv.y, resolution);
    const double inU = uv.x * resolution - i;
    const double inV = uv.y * resolution - j;
    const TexelCoord upper{narrow(i), narrow(j), TexelHalf::Upper};
    if (inU + inV > 1.0 && isValid(level, upper)) {
        return upper;
    }
    // Outside the hypotenuse the nearest cell of the column is the last valid one.
    return {narrow(i), narrow(std::min(j, resolution - 1 - i)), TexelHalf::Lower};
}

} // namespace trixel
