// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/surface.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace trixel {

Surface::Surface(TriangleMesh mesh)
    : m_mesh(std::move(mesh))
{
    if (!m_mesh.positions.empty()) {
        m_low = m_high = m_mesh.positions.front();
    }
    for (const glm::vec3& position : m_mesh.positions) {
        m_low = glm::min(m_low, position);
        m_high = glm::max(m_high, position);
    }
}

Result<std::shared_ptr<const Surface>> Surface::build(TriangleMesh mesh, Progress& progress)
{
    const std::shared_ptr<Surface> surface(new Surface(std::move(mesh)));
    const TriangleMesh& m = surface->m_mesh;
    if (!progress.report(0.0)) {
        return cancelled();
    }
    surface->m_adjacency = buildAdjacency(m.triangles);
    if (!progress.report(0.2)) {
        return cancelled();
    }
    surface->m_halfEdges = HalfEdges(m.triangles, m.positions.size(), surface->m_adjacency);
    if (!progress.report(0.4)) {
        return cancelled();
    }
    surface->m_report = inspectMesh(m, surface->m_adjacency);
    const auto refused = surface->m_halfEdges.refusedFaces();
    surface->m_report.halfEdgeRefusedFaces.assign(refused.begin(), refused.end());
    if (!progress.report(0.5)) {
        return cancelled();
    }
    surface->m_bvh = Bvh(m);
    if (!progress.report(1.0)) {
        return cancelled();
    }
    return surface;
}

float Surface::size() const
{
    // In double: the square of a large float overflows.
    return static_cast<float>(glm::length(glm::dvec3(m_high) - glm::dvec3(m_low)));
}

} // namespace trixel
