// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/mesh/adjacency.h"
#include "core/mesh/bvh.h"
#include "core/mesh/half_edges.h"
#include "core/mesh/mesh_report.h"
#include "core/mesh/triangle_mesh.h"

#include <memory>

namespace trixel {

/// A mesh with all that is derived from it once. Immutable and shared.
class Surface
{
public:
    /// Builds adjacency, half-edges, report and hierarchy. Fails only when cancelled.
    static Result<std::shared_ptr<const Surface>> build(TriangleMesh mesh, Progress& progress);

    Surface(const Surface&) = delete; // the hierarchy refers to the mesh beside it
    Surface& operator=(const Surface&) = delete;

    const TriangleMesh& mesh() const { return m_mesh; }
    const Adjacency& adjacency() const { return m_adjacency; }
    const MeshReport& report() const { return m_report; }
    const HalfEdges& halfEdges() const { return m_halfEdges; }
    const Bvh& bvh() const { return m_bvh; }

    glm::vec3 low() const { return m_low; }   ///< bounding box
    glm::vec3 high() const { return m_high; } ///< bounding box
    /// Length of the bounding box's diagonal, in world units.
    float size() const;

private:
    explicit Surface(TriangleMesh mesh);

    TriangleMesh m_mesh;
    Adjacency m_adjacency;
    HalfEdges m_halfEdges;
    MeshReport m_report;
    Bvh m_bvh;
    glm::vec3 m_low{0};
    glm::vec3 m_high{0};
};

} // namespace trixel
