// SPDX-License-Identifier: GPL-3.0-or-later
//
// A limit surface as triangles: as few as a stated error allows, without cracks.
#pragma once

#include "core/base/parallel.h"
#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/mesh/error_scale.h"
#include "core/mesh/limit_bends.h"
#include "core/mesh/limit_patterns.h"

#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <memory>
#include <span>
#include <vector>

namespace trixel {

/// A corner of tessellation triangles, of one face of the cage. As a graphics card reads it.
struct LimitVertex
{
    glm::vec3 position{0};
    std::uint32_t normal = 0; ///< by `packNormal`
    glm::vec2 uv{0};          ///< of the face
    std::uint32_t face = 0;   ///< of the cage

    bool operator==(const LimitVertex&) const = default;
};

struct LimitDemand
{
    ErrorScale scale = ErrorScale::ofWorld();
    double error = 0.5;                    ///< in the scale's units, > 0
    std::size_t mostTriangles = 4'000'000; ///< but never less than one a face
};

/// A tessellated limit surface. The faces follow each other, each with vertices and triangles of
/// its own; along a shared edge and at a shared vertex the positions are equal to the bit.
/// Immutable and shared.
class LimitTessellation
{
public:
    /// Every triangle is off the limit surface by at most `error()`, between points of the same
    /// (u,v): that is the demanded error, or more where the triangles would be too many or a face
    /// would be cut into more than kMaxRate pieces a side. Faces out of view may stay whole. The
    /// same demand gives the same bits, whatever the threads and the tessellation before.
    /// \param before  of the same surface, or nothing; saves evaluating the faces that stay as cut
    /// Fails only when cancelled.
    static Result<std::shared_ptr<const LimitTessellation>>
    make(std::shared_ptr<const LimitBends> bends,
         const LimitDemand& demand,
         std::shared_ptr<const LimitTessellation> before,
         Threads threads,
         Progress& progress);

    const LimitBends& bends() const { return *m_bends; }
    const std::shared_ptr<const LimitBends>& sharedBends() const { return m_bends; }
    const LimitSurface& surface() const { return m_bends->surface(); }

    std::span<const LimitVertex> vertices() const { return m_vertices; }
    /// Three numbers of vertices each, counter-clockwise.
    std::span<const Triangle> triangles() const { return m_triangles; }
    FaceId faceOf(std::size_t triangle) const
    {
        return faceId(m_vertices[m_triangles[triangle][0]].face);
    }
    /// Those of one face, in the order of `CutPattern::points`: its border first.
    std::span<const LimitVertex> vertices(FaceId face) const
    {
        const std::uint32_t first = m_firstVertex[indexOf(face)];
        return vertices().subspan(first, m_firstVertex[indexOf(face) + 1] - first);
    }
    /// How a face is cut.
    const CutRates& rates(FaceId face) const { return m_rates[indexOf(face)]; }
    /// Most units of error of faces in view.
    double error() const { return m_error; }
    /// Whether another demand would cut any face otherwise.
    bool isAsDemanded(const LimitDemand& demand) const;

private:
    class Build;

    std::shared_ptr<const LimitBends> m_bends;
    std::vector<CutRates> m_rates;            ///< one a face
    std::vector<std::uint32_t> m_firstVertex; ///< of each face, and their number
    std::vector<std::uint32_t> m_firstTriangle;
    std::vector<LimitVertex> m_vertices;
    std::vector<Triangle> m_triangles;
    double m_error = 0;
};

} // namespace trixel
