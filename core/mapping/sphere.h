// SPDX-License-Identifier: GPL-3.0-or-later
//
// Spherical mapping of a 2D image: u runs once round the y axis, v from the lower pole to the
// upper.
#pragma once

#include "core/footprint/footprint.h"

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace trixel {

/// Image coordinates of a direction: u = frac(atan2(z,x)/2π + 1/4), in [0,1); v = latitude/π + 1/2,
/// in [0,1]. The seam is at u = 0 (x = 0, z < 0), the poles at v = 0 and 1. Defined for every
/// input: at a pole u is 1/4; a zero or non-finite direction gives (1/4, 1/2). \param direction  of
/// any length
glm::dvec2 sphereUv(glm::dvec3 direction);

/// Footprint of a pixel in the image, analytic: no difference of coordinates is taken, so the seam
/// does not show. Longitude changes without bound towards a pole; W is limited to one period there
/// and to the image's height.
/// \param direction  of any length but 0
/// \param perA, perB  change of the direction from one pixel to the next
Footprint sphereFootprint(glm::dvec3 direction, glm::dvec3 perA, glm::dvec3 perB);

} // namespace trixel
