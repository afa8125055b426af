// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/triangle_mesh.h"

#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

namespace trixel::render {

/// A unit vector in 32 bits: its octahedral map, 16 bits each way.
std::uint32_t packNormal(glm::vec3 normal);

/// Shading normals of the three corners of every face, packed; face f's are at 3f…3f+2.
/// A corner takes the mean, weighted by angle, of the faces around its vertex that turn from its
/// own face by less than the crease, so that round parts look smooth and hard edges stay hard.
/// Degenerate faces get (0,0,1) where nothing better is known.
std::vector<std::uint32_t> cornerNormals(const TriangleMesh& mesh, float creaseDegrees = 50.0F);

} // namespace trixel::render
