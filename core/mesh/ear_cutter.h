// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/triangle_mesh.h"

#include <span>

namespace trixel {

/// `cutPolygon` for five corners and more.
void cutEars(std::span<const glm::vec3> positions,
             std::span<const std::uint32_t> corners,
             std::span<Triangle> triangles);

} // namespace trixel
