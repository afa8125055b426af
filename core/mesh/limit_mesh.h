// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/bvh.h"
#include "core/mesh/limit_tessellation.h"

#include <memory>
#include <optional>
#include <vector>

namespace trixel {

/// A tessellated limit surface to be met by rays and searched; answers are in faces and (u,v) of
/// the cage, and their positions lie on the limit surface itself. Immutable and shared.
class LimitMesh
{
public:
    /// Takes about 0.4 s of processor time for a million triangles.
    static std::shared_ptr<const LimitMesh>
    build(std::shared_ptr<const LimitTessellation> tessellation, Threads threads = Threads::all());

    LimitMesh(const LimitMesh&) = delete; // the hierarchy refers to the mesh beside it
    LimitMesh& operator=(const LimitMesh&) = delete;

    const LimitTessellation& tessellation() const { return *m_tessellation; }
    const std::shared_ptr<const LimitTessellation>& sharedTessellation() const
    {
        return m_tessellation;
    }
    const LimitSurface& surface() const { return m_tessellation->surface(); }

    /// What a ray meets first; see `Bvh::raycast`.
    std::optional<SurfacePoint> raycast(const Ray& ray) const;
    /// The same; faster for rays that meet the same face one after the other.
    /// \param evaluator  of `surface()`; afterwards at the face that was met
    std::optional<SurfacePoint> raycast(const Ray& ray, LimitSurface::Evaluator& evaluator) const;

    /// Appends the faces whose triangles come within `radius` of `centre`, ascending, each once.
    void facesWithin(glm::vec3 centre, float radius, std::vector<FaceId>& faces) const;

    /// Nearest point, if its triangle lies within `maxDistance`; see `Bvh::closestPoint`.
    std::optional<SurfacePoint> closestPoint(glm::vec3 position, float maxDistance) const;

private:
    explicit LimitMesh(std::shared_ptr<const LimitTessellation> tessellation, Threads threads);
    SurfacePoint onLimit(const SurfacePoint& onTriangle, LimitSurface::Evaluator& evaluator) const;

    std::shared_ptr<const LimitTessellation> m_tessellation;
    TriangleMesh m_mesh;
    Bvh m_bvh;
};

} // namespace trixel
