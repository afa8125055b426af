// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/texture/conforming_pyramid.h"
#include "core/texture/touched_cells.h"
#include "core/texture/vertex_averages.h"

#include <functional>
#include <vector>

namespace trixel {

/// Brings one group of channels up to date about touched cells, whose faces keep their levels:
/// own vertices, those of neighbours on shared edges and corners, and what is derived from them.
class PyramidUpdate
{
public:
    /// Where a face's vertices of a level begin, to be written to.
    using Writable = std::function<float*(FaceId, Level)>;

    PyramidUpdate(const FloatMips& mips,
                  const Adjacency& adjacency,
                  const VertexRings& rings,
                  int group,
                  Writable writable)
        : m_mips(mips)
        , m_adjacency(adjacency)
        , m_rings(rings)
        , m_averages(mips, adjacency, rings, group)
        , m_writable(std::move(writable))
    {
    }

    void touch(FaceId face, const TouchedRect& rect);
    /// What rule 3 derives from vertices that were touched; last.
    void derive();

    /// Vertices that were set.
    std::size_t count() const { return m_count; }

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

    const FloatMips& m_mips;
    const Adjacency& m_adjacency;
    const VertexRings& m_rings;
    VertexAverages m_averages;
    Writable m_writable;
    std::vector<Span> m_spans;
    std::size_t m_count = 0;
};

} // namespace trixel
