// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/vertex_rings.h"
#include "core/texture/touched_cells.h"
#include "core/texture/vertex_averages.h"

#include <functional>
#include <vector>

namespace trixel {

/// Finds the vertices of the conforming pyramid that depend on touched texels, in faces that keep
/// their levels: those about the texels, those of neighbours on shared edges and corners, their
/// like at coarser levels, and what rule 3 derives from them. Whoever derives from this does
/// something about each.
class VertexTouch
{
public:
    using LevelOf = std::function<Level(FaceId)>;

    VertexTouch(const Adjacency& adjacency, const VertexRings& rings, LevelOf level)
        : m_adjacency(adjacency)
        , m_rings(rings)
        , m_level(std::move(level))
    {
    }
    virtual ~VertexTouch() = default;

    /// \param base  level whose texels the rectangle counts, not below the face's
    void touch(FaceId face, Level base, const TouchedRect& rect);
    /// What rule 3 derives from vertices that were touched; last.
    void derive();

protected:
    VertexTouch(const VertexTouch&) = default;
    VertexTouch& operator=(const VertexTouch&) = delete;

    /// Rule 1: vertices (i0…i1, j), of which only those inside the face count.
    virtual void
    row(FaceId face, Level level, std::uint32_t j, std::uint32_t i0, std::uint32_t i1) = 0;
    /// Rules 2 and 5: vertex k of an edge, 0 < k < R.
    virtual void edge(FaceId face, LocalEdge edge, Level level, std::uint32_t k) = 0;
    /// Rule 4.
    virtual void corner(FaceId face, std::uint8_t corner, Level ringBase, Level level) = 0;
    /// Rule 3: vertices k0…k1 of an edge, all of them inside it. \param base  the edge's
    virtual void derived(FaceId face,
                         LocalEdge edge,
                         Level base,
                         Level level,
                         std::uint32_t k0,
                         std::uint32_t k1) = 0;

private:
    /// Vertices k0…k1 of an edge of a face at its base level changed, which finer levels derive.
    struct Span
    {
        FaceId face{};
        LocalEdge edge{};
        Level base;
        std::uint32_t k0 = 0, k1 = 0;
    };

    void touchCells(FaceId face, Level level, const CellRect& cells);
    void touchEdge(FaceId face, LocalEdge edge, Level level, std::uint32_t k0, std::uint32_t k1);
    void touchCorner(FaceId face, std::uint8_t corner, Level level);
    void deriveSpan(const Span& span);
    Level edgeBase(FaceId face, LocalEdge edge) const;
    Level ringBase(FaceId face, std::uint8_t corner) const;

    const Adjacency& m_adjacency;
    const VertexRings& m_rings;
    LevelOf m_level;
    std::vector<Span> m_spans;
};

} // namespace trixel
