// SPDX-License-Identifier: GPL-3.0-or-later
//
// Footprints that need no view: along the axes of the texture, and by hand.
#pragma once

#include "core/footprint/footprint.h"

namespace trixel {

/// W1 = (uw, 0), W2 = (0, vw): the box that texture look-ups without a view ask for.
/// \param uw, vw  widths in (u,v) of the face
Footprint textureAligned(double uw, double vw);

/// The footprint whose ellipse has these conjugate half axes (one standard deviation each), as
/// dragged at the handles of an ellipse; in (u,v). W is twice the half axis.
Footprint fromHalfAxes(glm::dvec2 first, glm::dvec2 second);

/// By numbers, in the equilateral metric (X = u + v/2, Y = √3/2 v, edges of length 1).
/// \param width       of the shorter side, in edges
/// \param anisotropy  longer side over shorter
/// \param angle       of the longer side against V0→V1, in radians
Footprint equilateralFootprint(double width, double anisotropy, double angle);

} // namespace trixel
