// SPDX-License-Identifier: GPL-3.0-or-later
//
// How far each face of a limit surface departs from flat triangles: measured once, whatever it is
// looked at from.
#pragma once

#include "core/base/parallel.h"
#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/mesh/error_scale.h"
#include "core/mesh/limit_surface.h"

#include <array>
#include <memory>
#include <span>
#include <vector>

namespace trixel {

/// Errors are world units between points of the same (u,v). Cut into n pieces a side, the triangles
/// are off by the number here divided by n^power.
struct FaceBend
{
    std::array<float, 3> along{}; ///< of triangles whose sides along an edge are long
    float inside = 0;             ///< of triangles like the face
    float power = 2; ///< less next to a vertex of other than six faces, where (u,v) are stretched
    FaceBounds bounds;
};

/// Where an edge or a vertex of the cage is evaluated, so that all its faces have the same point.
struct LimitOwner
{
    std::uint32_t face = 0;
    std::uint32_t corner = 0; ///< of the vertex; of the edge, the one it starts from in that face
};

/// A limit surface with what tessellating it needs. Immutable and shared.
class LimitBends
{
public:
    /// Takes 1 µs a regular face, up to 20 µs others. Fails only when cancelled.
    static Result<std::shared_ptr<const LimitBends>>
    measure(std::shared_ptr<const LimitSurface> surface, Threads threads, Progress& progress);

    const LimitSurface& surface() const { return *m_surface; }
    const std::shared_ptr<const LimitSurface>& sharedSurface() const { return m_surface; }
    /// One a face.
    std::span<const FaceBend> faces() const { return m_faces; }
    /// One an edge of the surface: the lowest face.
    std::span<const LimitOwner> edgeOwners() const { return m_edgeOwners; }
    /// One a vertex of the cage: the lowest face; of vertices without faces it means nothing.
    std::span<const LimitOwner> vertexOwners() const { return m_vertexOwners; }

private:
    LimitBends() = default;
    void findOwners();

    std::shared_ptr<const LimitSurface> m_surface;
    std::vector<FaceBend> m_faces;
    std::vector<LimitOwner> m_edgeOwners;
    std::vector<LimitOwner> m_vertexOwners;
};

} // namespace trixel
