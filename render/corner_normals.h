// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/triangle_mesh.h"

#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

namespace trixel::render {

/// A unit vector in 32 bits: its octahedral map, 16 bits each way.
std::uint32_t packNormal(glm::vec3 normal);

/// Those of `trixel::cornerNormals`, packed.
std::vector<std::uint32_t> cornerNormals(const TriangleMesh& mesh, float creaseDegrees = 50.0F);

} // namespace trixel::render
