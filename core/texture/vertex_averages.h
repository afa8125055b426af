// SPDX-License-Identifier: GPL-3.0-or-later
//
// The rules of the conforming pyramid, one lattice vertex at a time; see `ConformingPyramid`.
#pragma once

#include "core/mesh/vertex_rings.h"
#include "core/texture/float_mips.h"

#include <cmath>
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

/// The row j that a vertex lies in; `latticeVertex` backwards.
inline std::uint32_t latticeRow(Level level, std::uint32_t vertex)
{
    const double b = 2.0 * level.resolution() + 3;
    // The root is off by an ulp at most, and so by a row.
    auto j = static_cast<std::uint32_t>((b - std::sqrt(b * b - 8.0 * vertex)) / 2);
    while (latticeVertex(level, 0, j + 1) <= vertex) {
        ++j;
    }
    while (latticeVertex(level, 0, j) > vertex) {
        --j;
    }
    return j;
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
/// \tparam Mips  where texels come from: `FloatMips`, or `FaceMips` that makes them when asked
template <class Mips>
class BasicVertexAverages
{
public:
    BasicVertexAverages(const Mips& mips,
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
    /// \param values  of the level, of which the row's are written
    std::size_t row(FaceId face,
                    Level level,
                    std::uint32_t j,
                    std::uint32_t i0,
                    std::uint32_t i1,
                    float* values) const;

    /// The same, with the value of vertex (i0, j) at `first`; all must be inside.
    void insideRow(FaceId face,
                   Level level,
                   std::uint32_t j,
                   std::uint32_t i0,
                   std::uint32_t i1,
                   float* first) const;

    /// The coarser of the two levels that meet at an edge, which values on it derive from; the own
    /// at a border.
    Level edgeBase(FaceId face, LocalEdge edge) const;

    /// Rules 2 and 5: vertex k of an edge, 0 < k < R, level not above edgeBase.
    void onEdgeOf(FaceId face, LocalEdge edge, Level level, std::uint32_t k, float* values) const;
    /// The same into `value`.
    void edgeValue(FaceId face, LocalEdge edge, Level level, std::uint32_t k, float* value) const;

    /// Rule 3: vertex k of an edge, 0 < k < R, at a level above `base`, the edge's.
    static void derive(LocalEdge edge,
                       Level base,
                       const float* baseValues,
                       Level level,
                       std::uint32_t k,
                       float* values);

    /// The value at t in [0, 1) between two of rule 3's.
    static void between(const float* from, const float* to, double t, float* value);

    /// The coarsest base about a corner.
    Level ringBase(FaceId face, std::uint8_t corner) const;

    /// Rule 4. \param ringBase  of the corner
    void
    atCorner(FaceId face, std::uint8_t corner, Level ringBase, Level level, float* values) const;
    /// The same into `value`.
    void
    cornerValue(FaceId face, std::uint8_t corner, Level ringBase, Level level, float* value) const;

private:
    const Mips& m_mips;
    const Adjacency& m_adjacency;
    const VertexRings& m_rings;
    int m_group;
};

using VertexAverages = BasicVertexAverages<FloatMips>;

} // namespace trixel
