// SPDX-License-Identifier: GPL-3.0-or-later
//
// Averages at the vertices of every face's lattice, at every level: what a face interpolates
// between, so that neighbours agree along their whole edge whatever their levels, their shapes and
// the valence of their corners.
//
// Rules, from the texels of each level (unrounded means of the finer ones):
//   1. interior vertex: mean of its 6 texels;
//   2. edge vertex, both faces at this level: mean of 3 own and 3 neighbour texels;
//   3. edge vertex at a level finer than the coarser face's base: linear interpolation of the edge
//      vertices at that base;
//   4. mesh vertex: mean over the ring's faces of their corner texel at min(level, coarsest base
//      among them);
//   5. border edge: only its own texels to average.
#pragma once

#include "core/base/parallel.h"
#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/mesh/vertex_rings.h"
#include "core/texture/float_mips.h"
#include "core/texture/touched_rect.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>

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

/// Averages of one face at one level: vertex k begins at values + stride * k, four channels.
struct LevelVertices
{
    const float* values = nullptr;
    std::uint32_t stride = kGroupChannels; ///< 0 where the face and all about it are one constant
};

class ConformingPyramid
{
public:
    ConformingPyramid() = default;

    /// Fails only when cancelled. Faces whose texels and surroundings are shared share their
    /// averages too.
    static Result<ConformingPyramid> build(const FloatMips& mips,
                                           const Adjacency& adjacency,
                                           const VertexRings& rings,
                                           Threads threads,
                                           Progress& progress);

    /// Takes over what changed, after `mips` did: the lattice vertices about the touched texels,
    /// those of neighbours among them, and their parents. Equal to building anew.
    void update(const FloatMips& mips,
                const Adjacency& adjacency,
                const VertexRings& rings,
                std::span<const TouchedRect> rects);

    std::size_t faceCount() const { return m_faces.size(); }
    Level level(FaceId face) const { return m_faces[face]->level; }

    /// \param level  not above level(face) (checked)
    /// \param group  of four channels
    LevelVertices vertices(FaceId face, Level level, int group = 0) const;

    /// Vertex values as addressed, all levels, whether stored or shared.
    std::uint64_t valueCount() const;
    std::size_t memoryBytes() const;

private:
    /// Levels from 0 up to the base, one group of channels after the other.
    struct Face
    {
        Level level;
        std::size_t groupSize = 0; ///< floats
        std::unique_ptr<float[]> values;
    };

    static std::shared_ptr<const Face> makeFace(const FloatMips& mips,
                                                const Adjacency& adjacency,
                                                const VertexRings& rings,
                                                FaceId id);

    FaceMap<std::shared_ptr<const Face>> m_faces;
    int m_groups = 0;
};

} // namespace trixel
