// SPDX-License-Identifier: GPL-3.0-or-later
//
// What is on the study's tile, by position in texels: x along the rows' direction and y across, in
// the oblique axes of the tile, both periodic in kTileTexels.
#pragma once

#include <glm/vec3.hpp>

namespace trixel {

/// Leaves of all sizes over each other, with soft edges, on noise whose power falls with frequency.
glm::dvec3 naturalContent(double x, double y);

/// Checks, stripes, discs and letter-like shapes, none of them smoothed.
glm::dvec3 hardEdgedContent(double x, double y);

} // namespace trixel
