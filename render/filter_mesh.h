// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/limit_tessellation.h"
#include "core/mesh/triangle_mesh.h"
#include "core/mesh/vertex_rings.h"
#include "core/texture/texel_store.h"

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

namespace trixel::render {

/// What the shader knows of a mesh vertex to choose levels by. Everything is one number a vertex,
/// so that what is interpolated from it is the same on both sides of an edge.
struct VertexScale
{
    float log2Length = 0; ///< mean log2 of the lengths of the edges that meet there, world units
    float log2Texel = 0;  ///< the same of a texel's edge: less the mean level of the faces there
    /// The mean of the faces' normals by their areas, a unit vector; from -1 to 1 in 16 bits each.
    std::array<std::uint16_t, 3> normal{};
    std::uint16_t flatness = 0; ///< how far the faces lie in one plane: 65535 where they do, 0
                                ///< where no one tilt fits them
};
static_assert(sizeof(VertexScale) == 16);

/// A mesh as filtering over lattice vertices needs it: who borders whom, and how large and how
/// turned the surface is at every vertex. Made away from the window's thread; shared and constant.
class FilterMesh
{
public:
    static constexpr std::uint32_t kBorder = 0xFFFFFFFFU;

    /// \param store  of the mesh's faces (checked); only its levels count
    /// \param limit  of the mesh, where that is looked at: sizes and turns are its own
    FilterMesh(const TriangleMesh& mesh,
               Adjacency adjacency,
               const TexelStore& store,
               const LimitTessellation* limit = nullptr);

    std::size_t faceCount() const { return m_across.size() / 3; }
    const Adjacency& adjacency() const { return m_adjacency; }
    const VertexRings& rings() const { return m_rings; }
    /// One a mesh vertex.
    const std::vector<VertexScale>& scales() const { return m_scales; }
    float longestEdge() const { return m_longestEdge; } ///< world units
    /// Three a face: neighbour << 2 | edge as it numbers it, or kBorder.
    const std::vector<std::uint32_t>& across() const { return m_across; }

private:
    void measure(const TriangleMesh& mesh, const TexelStore& store, const LimitTessellation* limit);

    float m_longestEdge = 0;
    Adjacency m_adjacency;
    VertexRings m_rings;
    std::vector<VertexScale> m_scales;
    std::vector<std::uint32_t> m_across;
};

} // namespace trixel::render
