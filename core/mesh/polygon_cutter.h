// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "core/mesh/polygon_list.h"
#include "core/mesh/triangle_mesh.h"

#include <span>

namespace trixel {

/// Cuts a polygon into corners.size() - 2 triangles that keep its winding: a fan where it is
/// convex, otherwise ears. A polygon that crosses itself, or has no area, is cut all the same.
/// Takes time linear in the corners (an intricate polygon ends as a fan after 1000 tests a corner).
/// \param corners    at least three vertex numbers, repetitions allowed
/// \param triangles  corners.size() - 2 of them, overwritten
void cutPolygon(std::span<const glm::vec3> positions,
                std::span<const std::uint32_t> corners,
                std::span<Triangle> triangles);

/// The mesh of all polygons in their order; fails where there is none, or 2^30 triangles or more.
/// \param parts  refer to vertices below positions.size(); may be emptied
Result<TriangleMesh> cutPolygons(std::vector<glm::vec3> positions, std::span<PolygonList> parts);

} // namespace trixel
