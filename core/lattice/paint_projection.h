// SPDX-License-Identifier: GPL-3.0-or-later
//
// The two rasterisations that cover the packed square. Each half of a face is drawn as the whole
// triangle, moved by 1/6 texel so that pixel centres meet texel centroids; the lower half as it
// is, the upper half mirrored about the diagonal. Without the offset the R texels on the diagonal
// come from the wrong half.
#pragma once

#include "core/lattice/texel.h"

#include <glm/vec2.hpp>

namespace trixel {

inline constexpr double kPaintOffset = 1.0 / 6.0;

/// Where (u,v) falls in the packed square, in pixels, when the given half is rasterised:
/// lower (uR + 1/6, vR + 1/6); upper (R - vR + 1/6, R - uR + 1/6).
glm::dvec2 toPacked(Level level, TexelHalf half, glm::dvec2 uv, double offset = kPaintOffset);

/// The inverse: which (u,v) a position in the packed square samples.
glm::dvec2 fromPacked(Level level, TexelHalf half, glm::dvec2 pixel, double offset = kPaintOffset);

} // namespace trixel
