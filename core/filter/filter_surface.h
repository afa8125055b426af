// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/adjacency.h"
#include "core/mesh/triangle_mesh.h"
#include "core/mesh/vertex_rings.h"

#include <array>
#include <cstdint>
#include <glm/vec2.hpp>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace trixel {

/// A face laid into its own plane, to scale: V0 at the origin, V1 on the x axis, V2 above it.
/// (u,v) lies at u e1 + v e2.
struct FaceShape
{
    glm::dvec2 e1{1, 0};
    glm::dvec2 e2{0.5, 0.86602540378443865};

    glm::dvec2 toPlane(glm::dvec2 uv) const { return uv.x * e1 + uv.y * e2; }
    glm::dvec2 toUv(glm::dvec2 plane) const
    {
        const double v = plane.y / e2.y;
        return {(plane.x - v * e2.x) / e1.x, v};
    }
};

/// The shape of a face in the world. One without area has no plane of its own: it is taken as
/// equilateral, its edges as long as its longest (1 where all are zero), so that every shape can be
/// inverted.
FaceShape faceShapeOf(const std::array<glm::vec3, 3>& corners);

/// What filters know of a mesh: who borders whom, and how the faces are shaped. Lengths are world
/// units, or edges where only the adjacency is known and every face is taken as equilateral.
class FilterSurface
{
public:
    FilterSurface() = default;

    /// Faces are shaped by `faceShapeOf`.
    static FilterSurface fromMesh(const TriangleMesh& mesh, Adjacency adjacency);

    /// Every face equilateral with edges of length 1, which is what the reference library means by
    /// a footprint.
    static FilterSurface equilateral(Adjacency adjacency);

    std::size_t faceCount() const { return m_shapes.size(); }
    const Adjacency& adjacency() const { return m_adjacency; }
    const VertexRings& rings() const { return m_rings; }
    const FaceShape& shape(FaceId face) const { return m_shapes[indexOf(face)]; }

    /// Where faces are neighbours: how (u,v) of a face becomes (u,v) of the one across an edge, the
    /// two unfolded into one plane at their true shapes.
    struct Crossing
    {
        FaceId face{};
        LocalEdge edge{}; ///< as the neighbour numbers it
        /// (u',v') = origin + u perU + v perV
        glm::dvec2 origin{0};
        glm::dvec2 perU{0};
        glm::dvec2 perV{0};

        glm::dvec2 point(glm::dvec2 uv) const { return origin + uv.x * perU + uv.y * perV; }
        glm::dvec2 vector(glm::dvec2 w) const { return w.x * perU + w.y * perV; }
    };
    /// Nothing at a border.
    std::optional<Crossing> crossing(FaceId face, LocalEdge edge) const;

    /// What a straight walk needs of a face, in one cache line. The vertex beyond edge e, the two
    /// faces unfolded into one plane, lies at
    ///   start + beyond[e][0] (end - start) + beyond[e][1] (far - start),
    /// start and end those of the edge, far the face's own third vertex.
    struct alignas(64) FaceSteps
    {
        static constexpr std::uint32_t kBorder = 0xFFFFFFFFU;

        std::array<std::array<double, 2>, 3> beyond{};
        /// Neighbour << 2 | edge as it numbers it.
        std::array<std::uint32_t, 3> across = {kBorder, kBorder, kBorder};
    };
    const FaceSteps& steps(FaceId face) const { return m_steps[indexOf(face)]; }

    /// The same where lengths and angles matter and the face is in its own plane: two to a cache
    /// line, for many walks at once. Lengths are in units of edge 0.
    struct alignas(32) LaneSteps
    {
        static constexpr std::uint32_t kBorder = FaceSteps::kBorder;

        /// V2, where V0 lies at the origin and V1 at (1,0).
        glm::dvec2 apex{0.5, 0.86602540378443865};
        /// Neighbour << 2 | edge as it numbers it.
        std::array<std::uint32_t, 3> across = {kBorder, kBorder, kBorder};
        /// From anywhere in the face a straight line of this length meets no border.
        float clearance = 0;

        /// The vertex opposite an edge, where that edge runs from the origin to (1,0).
        glm::dvec2 opposite(std::size_t edge) const
        {
            const glm::dvec2 z = edge == 1 ? glm::dvec2(1 - apex.x, -apex.y) : apex;
            const double perSquare = 1 / (z.x * z.x + z.y * z.y);
            const glm::dvec2 inverse(z.x * perSquare, -z.y * perSquare);
            return edge == 0 ? apex : edge == 1 ? inverse : glm::dvec2(1 - inverse.x, -inverse.y);
        }
    };
    static_assert(sizeof(LaneSteps) == 32);
    const LaneSteps& laneSteps(FaceId face) const { return m_laneSteps[indexOf(face)]; }
    /// Those of all faces, to gather from.
    std::span<const LaneSteps> laneSteps() const { return m_laneSteps; }

    /// Mean log2 of the lengths of the edges that meet at a corner: one number a vertex, so that
    /// what is interpolated from it over the faces is continuous.
    double log2Length(FaceId face, int corner) const
    {
        return m_log2Lengths[indexOf(m_rings.ring({face, static_cast<std::uint8_t>(corner)}))];
    }
    /// The same interpolated at a point of the face.
    double log2Length(FaceId face, glm::dvec2 uv) const;

private:
    void measureLengths();
    void layCrossings();
    void layLaneSteps();
    void measureClearance();

    Adjacency m_adjacency;
    VertexRings m_rings;
    std::vector<FaceShape> m_shapes;
    std::vector<FaceSteps> m_steps;
    std::vector<LaneSteps> m_laneSteps;
    std::vector<double> m_log2Lengths; // of each ring
};

} // namespace trixel
