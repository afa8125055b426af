// SPDX-License-Identifier: GPL-3.0-or-later
//
// The rules of the conforming pyramid, one lattice vertex at a time; see `ConformingPyramid`.
#pragma once

#include "core/mesh/vertex_rings.h"
#include "core/texture/float_mips.h"

#include <cstddef>
#include <cstdint>

namespace trixel {

/// Lattice vertices of a face at a level: (R+1)(R+2)/2, row j (v = j/R) from j(2R+3-j)/2 on.
constexpr std::size_t latticeVertexCount(Level level)
{
    const std::size_t r = level.resolution();
    return (r + 1) * (r + 2) / 2;
}

/// Where vertex (i/R, j/R) lies among them; i + j <= R.
constexpr std::size_t latticeVertex(Level level, std::uint32_t i, std::uint32_t j)
{
    return std::size_t{j} * (2 * std::size_t{level.resolution()} + 3 - j) / 2 + i;
}

/// Position on a face's lattice.
struct LatticePoint
{
    std::uint32_t i = 0;
    std::uint32_t j = 0;
};

/// Vertex number k along an edge, from its start.
constexpr LatticePoint onEdge(Level level, LocalEdge edge, std::uint32_t k)
{
    const std::uint32_t r = level.resolution();
    return edge == LocalEdge::E0   ? LatticePoint{k, 0}
           : edge == LocalEdge::E1 ? LatticePoint{r - k, k}
                                   : LatticePoint{0, r - k};
}

/// Computes averages of one group of channels into blocks whose vertices of a level, four floats
/// each, begin at `values`. Means are summed in double, so that neither order nor constants lose
/// anything.
class VertexAverages
{
public:
    VertexAverages(const FloatMips& mips,
                   const Adjacency& adjacency,
                   const VertexRings& rings,
                   int group)
        : m_mips(mips)
        , m_adjacency(adjacency)
        , m_rings(rings)
        , m_group(group)
    {
    }

    /// Rule 1: vertices (i0…i1, j) that are inside the face; returns how many.
    std::size_t row(FaceId face,
                    Level level,
                    std::uint32_t j,
                    std::uint32_t i0,
                    std::uint32_t i1,
                    float* values) const;

    /// The coarser of the two levels that meet at an edge, which values on it derive from; the own
    /// at a border.
    Level edgeBase(FaceId face, LocalEdge edge) const;

    /// Rules 2 and 5: vertex k of an edge, 0 < k < R, level not above edgeBase.
    void onEdgeOf(FaceId face, LocalEdge edge, Level level, std::uint32_t k, float* values) const;

    /// Rule 3: vertex k of an edge, 0 < k < R, at a level above `base`, the edge's.
    static void derive(LocalEdge edge,
                       Level base,
                       const float* baseValues,
                       Level level,
                       std::uint32_t k,
                       float* values);

    /// The coarsest base about a corner.
    Level ringBase(FaceId face, std::uint8_t corner) const;

    /// Rule 4. \param ringBase  of the corner
    void
    atCorner(FaceId face, std::uint8_t corner, Level ringBase, Level level, float* values) const;

private:
    const FloatMips& m_mips;
    const Adjacency& m_adjacency;
    const VertexRings& m_rings;
    int m_group;
};

} // namespace trixel
