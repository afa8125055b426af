// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/limit_mesh.h"
#include "core/mesh/surface.h"

#include <array>
#include <optional>

namespace trixel::ui {

/// The surface as a view shows it: the cage, or its limit surface. Refers to both; for one thread.
class SeenSurface
{
public:
    /// \param limit  of the cage; null where the cage itself is shown
    explicit SeenSurface(const Surface& cage, const LimitMesh* limit = nullptr)
        : m_cage(cage)
        , m_limit(limit)
    {
    }

    const Surface& cage() const { return m_cage; }
    bool isLimit() const { return m_limit != nullptr; }

    std::optional<SurfacePoint> raycast(const Ray& ray) const;
    std::optional<SurfacePoint> closestPoint(glm::vec3 position, float maxDistance) const;
    glm::vec3 position(FaceId face, glm::vec2 uv) const;
    /// Corners of a flat face that is where the surface is at a point, with its derivatives there:
    /// of the cage, the face itself.
    std::array<glm::vec3, 3> tangentFace(FaceId face, glm::vec2 uv) const;
    /// Unit normal; zero where there is none.
    glm::vec3 normal(FaceId face, glm::vec2 uv) const;

private:
    /// At a face of the limit surface: points of one face after the other are cheap.
    LimitSurface::Evaluator& at(FaceId face) const;

    const Surface& m_cage;
    const LimitMesh* m_limit;
    mutable std::optional<LimitSurface::Evaluator> m_evaluator;
};

} // namespace trixel::ui
