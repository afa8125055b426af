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
#include "core/texture/shared_blocks.h"
#include "core/texture/touched_rect.h"
#include "core/texture/vertex_averages.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace trixel {

/// Averages of one face at one level: vertex k begins at values + stride * k, four channels.
struct LevelVertices
{
    const float* values = nullptr;
    std::uint32_t stride = kGroupChannels; ///< 0 where the face and all about it are one constant
};

namespace detail {

/// Floats of one group below each level; one more for all of them.
constexpr std::array<std::size_t, Level::kMax + 2> pyramidBegins()
{
    std::array<std::size_t, Level::kMax + 2> begins{};
    for (int n = 0; n <= Level::kMax; ++n) {
        begins[static_cast<std::size_t>(n) + 1] =
            begins[static_cast<std::size_t>(n)] + kGroupChannels * latticeVertexCount(Level(n));
    }
    return begins;
}
inline constexpr auto kPyramidBegins = pyramidBegins();

} // namespace detail

class ConformingPyramid
{
public:
    ConformingPyramid() = default;

    /// Fails only when cancelled. Faces whose values and surroundings are alike, as those of tiles
    /// are, share one block; a face that is one constant with all about it is one vertex.
    static Result<ConformingPyramid> build(const FloatMips& mips,
                                           const Adjacency& adjacency,
                                           const VertexRings& rings,
                                           Threads threads,
                                           Progress& progress);

    /// Takes over what changed, after `mips` did: the lattice vertices about the touched texels,
    /// those of neighbours among them and what is derived from them, and their parents. Faces whose
    /// level changed are made anew with all about them. The values are those of building anew.
    /// \return  vertices that were set, all levels and groups
    std::size_t update(const FloatMips& mips,
                       const Adjacency& adjacency,
                       const VertexRings& rings,
                       std::span<const TouchedRect> rects);

    std::size_t faceCount() const { return m_blocks.faceCount(); }
    Level level(FaceId face) const { return m_blocks.block(face).level; }

    /// \param level  not above level(face) (checked)
    /// \param group  of four channels
    LevelVertices vertices(FaceId face, Level level, int group = 0) const
    {
        const SharedBlocks::Block& block = m_blocks.block(face);
        check(level <= block.level, "a level that the face has");
        const auto number = static_cast<std::size_t>(group);
        if (block.constant) {
            return {block.values.get() + number * kConstantSize, 0};
        }
        return {block.values.get() + number * groupSize(block.level) + levelBegin(level)};
    }

    /// The finest level of a face that is not above `most`, first group: for inner loops. Where all
    /// about a face is one constant, that is level 0.
    struct Finest
    {
        const float* values = nullptr; ///< four floats a vertex
        Level level;
        bool constant = false;
    };
    Finest finest(FaceId face, Level most) const
    {
        const SharedBlocks::Block& block = m_blocks.block(face);
        const float* values = block.values.get();
        if (block.constant) {
            return {values, Level(0), true};
        }
        const Level level = block.level < most ? block.level : most;
        return {values + levelBegin(level), level, false};
    }

    /// Floats of one group of a constant face: the value at each vertex of level 0, because those
    /// who interpolate read three.
    static constexpr std::size_t kConstantSize = 3 * std::size_t{kGroupChannels};
    /// Floats of one group of channels before a level; coarse levels come first.
    static constexpr std::size_t levelBegin(Level level)
    {
        return detail::kPyramidBegins[static_cast<std::size_t>(level.log2())];
    }
    /// Floats of one group of a face.
    static constexpr std::size_t groupSize(Level base)
    {
        return detail::kPyramidBegins[static_cast<std::size_t>(base.log2()) + 1];
    }

    /// Vertex values as addressed, all levels, whether stored or shared.
    std::uint64_t valueCount() const;
    std::size_t memoryBytes() const { return m_blocks.memoryBytes(); }

private:
    class Builder;

    /// A block of its own for the face, every level spread out.
    float* spreadOut(FaceId face);

    SharedBlocks m_blocks;
    int m_groups = 0;
};

} // namespace trixel
