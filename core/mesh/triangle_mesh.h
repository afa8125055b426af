// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/ids.h"
#include "core/mesh/crease.h"

#include <array>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

namespace trixel {

/// Three vertex numbers, counter-clockwise seen from outside.
using Triangle = std::array<std::uint32_t, 3>;

/// Whether a vertex occurs more than once: such a triangle has no area and no neighbours.
constexpr bool repeatsVertex(const Triangle& t)
{
    return t[0] == t[1] || t[1] == t[2] || t[2] == t[0];
}

/// Index arrays of a triangle mesh. Every index is below the vertex count and every position is
/// finite: the readers and builders see to it.
struct TriangleMesh
{
    std::vector<glm::vec3> positions;
    /// In the order of the file; the position in this array is the `FaceId`.
    std::vector<Triangle> triangles;
    /// The polygon of the file each triangle was cut from; empty when every polygon was a triangle.
    std::vector<std::uint32_t> sourceFaces;
    /// What the file says of subdivision: each edge and each vertex once, edges of the mesh alone.
    Sharpness sharpness = {};
    /// Places in an image, three a face in the order of its corners: s to the right, t upwards, one
    /// image a unit. NaN where a corner has none; empty when no corner has one.
    std::vector<glm::vec2> cornerUvs = {};

    std::size_t faceCount() const { return triangles.size(); }

    /// Positions of V0, V1, V2.
    std::array<glm::vec3, 3> corners(FaceId face) const
    {
        const Triangle& t = triangles[indexOf(face)];
        return {positions[t[0]], positions[t[1]], positions[t[2]]};
    }

    /// Whether some corner has a place in an image.
    bool hasUvs() const { return !cornerUvs.empty(); }
    /// Those of V0, V1, V2. The mesh has uvs (`hasUvs`).
    std::array<glm::vec2, 3> uvs(FaceId face) const
    {
        const glm::vec2* first = cornerUvs.data() + 3 * indexOf(face);
        return {first[0], first[1], first[2]};
    }

    std::uint32_t sourceFace(FaceId face) const
    {
        return sourceFaces.empty() ? static_cast<std::uint32_t>(face) : sourceFaces[indexOf(face)];
    }
};

/// Point of a face: V0 + u (V1 - V0) + v (V2 - V0).
inline glm::vec3 pointAt(const std::array<glm::vec3, 3>& corners, float u, float v)
{
    return corners[0] + u * (corners[1] - corners[0]) + v * (corners[2] - corners[0]);
}

} // namespace trixel
