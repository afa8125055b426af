// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/parallel.h"
#include "core/mesh/bvh_node.h"
#include "core/mesh/triangle_mesh.h"

#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <vector>

namespace trixel {

struct Ray
{
    glm::vec3 origin{0};
    glm::vec3 direction{0, 0, -1}; ///< need not be of unit length; not zero
};

/// A point of the surface.
struct SurfacePoint
{
    FaceId face{};
    glm::vec2 uv{0}; ///< u, v >= 0 and u + v <= 1
    glm::vec3 position{0};
};

/// Bounding-volume hierarchy over the faces of a mesh. The mesh must outlive it and not change.
/// Answers do not depend on how the tree was built: ties go to the lowest face.
class Bvh
{
public:
    Bvh() = default;
    /// Takes about 0.4 s of processor time for a million faces, shared by the threads.
    explicit Bvh(const TriangleMesh& mesh, Threads threads = Threads::all());

    /// Nearest face that the ray meets in front of its origin, from either side. Degenerate faces
    /// are not met. Rays do not slip between faces that share an edge. Nothing for a ray that is
    /// not finite or has no direction.
    std::optional<SurfacePoint> raycast(const Ray& ray) const;

    /// Appends the faces that come within `radius` of `centre`, degenerate ones included, in
    /// ascending order of id (so that results never depend on the tree).
    void facesWithin(glm::vec3 centre, float radius, std::vector<FaceId>& faces) const;

    /// Nearest point of the surface, if one lies within `maxDistance` (which may be infinite).
    std::optional<SurfacePoint> closestPoint(glm::vec3 position, float maxDistance) const;

    std::size_t memoryBytes() const;

private:
    const TriangleMesh* m_mesh = nullptr;
    std::vector<BvhNode> m_nodes;
    std::vector<FaceId> m_faces;
};

} // namespace trixel
