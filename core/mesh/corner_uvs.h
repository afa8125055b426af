// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/polygon_list.h"
#include "core/mesh/triangle_mesh.h"

#include <cstdint>
#include <span>
#include <vector>

namespace trixel {

/// Stands for a corner that a file gives no place in an image.
inline constexpr std::uint32_t kNoUv = 0xFFFFFFFFU;

/// Numbers of places in an image, one for each corner of a list of polygons.
using UvNumbers = std::vector<std::uint32_t>;

/// The places of the corners of triangles that were cut from polygons. Where a polygon passes one
/// vertex twice, the place of the first stands for both.
/// \param triangles  cut from the polygons in their order, each part by `cutPolygons`
/// \param parts      as they were cut; triangles of a part that was all triangles may be gone
/// \param numbers    of each part (checked); below uvs.size(), or kNoUv
/// \return           three a triangle; nothing if no corner has a place
std::vector<glm::vec2> cornerUvs(std::span<const Triangle> triangles,
                                 std::span<const PolygonList> parts,
                                 const std::vector<UvNumbers>& numbers,
                                 std::span<const glm::vec2> uvs);

/// The same where places belong to vertices.
/// \param vertexUvs  one for each vertex of the triangles (checked), NaN for none
std::vector<glm::vec2> cornerUvsOfVertices(std::span<const Triangle> triangles,
                                           std::span<const glm::vec2> vertexUvs);

} // namespace trixel
