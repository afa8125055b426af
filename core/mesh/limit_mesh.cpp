// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/limit_mesh.h"

#include "core/mesh/triangle_geometry.h"

#include <algorithm>

namespace trixel {

std::shared_ptr<const LimitMesh>
LimitMesh::build(std::shared_ptr<const LimitTessellation> tessellation, Threads threads)
{
    return std::shared_ptr<const LimitMesh>(new LimitMesh(std::move(tessellation), threads));
}

LimitMesh::LimitMesh(std::shared_ptr<const LimitTessellation> tessellation, Threads threads)
    : m_tessellation(std::move(tessellation))
{
    const auto vertices = m_tessellation->vertices();
    m_mesh.positions.resize(vertices.size());
    std::ranges::transform(vertices, m_mesh.positions.begin(), &LimitVertex::position);
    const auto triangles = m_tessellation->triangles();
    m_mesh.triangles.assign(triangles.begin(), triangles.end());
    m_bvh = Bvh(m_mesh, threads);
}

SurfacePoint LimitMesh::onLimit(const SurfacePoint& p, LimitSurface::Evaluator& evaluator) const
{
    const Triangle& t = m_mesh.triangles[indexOf(p.face)];
    const auto uvAt = [&](std::uint32_t vertex) {
        return glm::dvec2(m_tessellation->vertices()[vertex].uv);
    };
    const glm::dvec2 a = uvAt(t[0]);
    const glm::dvec2 uv = a + double{p.uv.x} * (uvAt(t[1]) - a) + double{p.uv.y} * (uvAt(t[2]) - a);
    SurfacePoint result;
    result.face = m_tessellation->faceOf(indexOf(p.face));
    result.uv = insideTriangle(uv);
    evaluator.moveTo(result.face);
    result.position = glm::vec3(evaluator.position(glm::dvec2(result.uv)));
    return result;
}

std::optional<SurfacePoint> LimitMesh::raycast(const Ray& ray) const
{
    LimitSurface::Evaluator evaluator(surface());
    return raycast(ray, evaluator);
}

std::optional<SurfacePoint> LimitMesh::raycast(const Ray& ray,
                                               LimitSurface::Evaluator& evaluator) const
{
    const auto hit = m_bvh.raycast(ray);
    return hit ? std::optional(onLimit(*hit, evaluator)) : std::nullopt;
}

void LimitMesh::facesWithin(glm::vec3 centre, float radius, std::vector<FaceId>& faces) const
{
    std::vector<FaceId> triangles;
    m_bvh.facesWithin(centre, radius, triangles);
    // Triangles ascend, and with them their faces.
    for (const FaceId triangle : triangles) {
        const FaceId face = m_tessellation->faceOf(indexOf(triangle));
        if (faces.empty() || faces.back() != face) {
            faces.push_back(face);
        }
    }
}

std::optional<SurfacePoint> LimitMesh::closestPoint(glm::vec3 position, float maxDistance) const
{
    const auto nearest = m_bvh.closestPoint(position, maxDistance);
    LimitSurface::Evaluator evaluator(surface());
    return nearest ? std::optional(onLimit(*nearest, evaluator)) : std::nullopt;
}

} // namespace trixel
