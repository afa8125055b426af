// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/triangle_mesh.h"

#include <glm/vec3.hpp>
#include <vector>

namespace trixel {

/// Shading normals of the three corners of every face, unit vectors; face f's are at 3f…3f+2.
/// A corner takes the mean, weighted by angle, of the faces around its vertex that turn from its
/// own face by less than the crease, so that round parts look smooth and hard edges stay hard.
/// Degenerate faces get (0,0,1) where nothing better is known.
std::vector<glm::vec3> cornerNormals(const TriangleMesh& mesh, float creaseDegrees = 50.0F);

} // namespace trixel
