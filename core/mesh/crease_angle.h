// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/surface.h"

namespace trixel {

/// Edges between two faces whose normals are more than an angle apart, sharp for ever, ascending.
/// Not those of faces without an area.
/// \param degrees  [0, 180]
std::vector<Crease> creasesByAngle(const Surface& surface, double degrees);

/// What subdivision of a surface does not round off: what its mesh says and, where an angle is
/// given, the edges folded by more. Where both speak of an edge, the mesh counts.
Sharpness sharpnessOf(const Surface& surface, CreaseAngle angle);

} // namespace trixel
