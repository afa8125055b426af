// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/level.h"

#include <cmath>
#include <glm/vec2.hpp>

namespace trixel {

/// A sine of 20 base-level texels from crest to crest, neither along the lattice nor across it,
/// between 0 and 1.
inline double studySine(Level level, glm::dvec2 uv)
{
    const double r = level.resolution();
    // In texels, in the equilateral plane, turned by 20 degrees.
    const double x = r * (uv.x + uv.y / 2);
    const double y = r * uv.y * 0.86602540378443865;
    const double along = 0.93969262078590838 * x + 0.34202014332566873 * y;
    return 0.5 + 0.5 * std::sin(6.283185307179586 * along / 20);
}

} // namespace trixel
