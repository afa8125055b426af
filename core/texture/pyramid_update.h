// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/texture/conforming_pyramid.h"
#include "core/texture/vertex_averages.h"
#include "core/texture/vertex_touch.h"

#include <functional>

namespace trixel {

/// Brings one group of channels up to date about touched cells, whose faces keep their levels:
/// own vertices, those of neighbours on shared edges and corners, and what is derived from them.
class PyramidUpdate final : private VertexTouch
{
public:
    /// Where a face's vertices of a level begin, to be written to.
    using Writable = std::function<float*(FaceId, Level)>;

    PyramidUpdate(const FloatMips& mips,
                  const Adjacency& adjacency,
                  const VertexRings& rings,
                  int group,
                  Writable writable)
        : VertexTouch(adjacency, rings, [&mips](FaceId face) { return mips.level(face); })
        , m_mips(mips)
        , m_averages(mips, adjacency, rings, group)
        , m_writable(std::move(writable))
    {
    }

    void touch(FaceId face, const TouchedRect& rect)
    {
        VertexTouch::touch(face, m_mips.level(face), rect);
    }
    /// What rule 3 derives from vertices that were touched; last.
    using VertexTouch::derive;

    /// Vertices that were set.
    std::size_t count() const { return m_count; }

private:
    void
    row(FaceId face, Level level, std::uint32_t j, std::uint32_t i0, std::uint32_t i1) override;
    void edge(FaceId face, LocalEdge edge, Level level, std::uint32_t k) override;
    void corner(FaceId face, std::uint8_t corner, Level ringBase, Level level) override;
    void derived(FaceId face,
                 LocalEdge edge,
                 Level base,
                 Level level,
                 std::uint32_t k0,
                 std::uint32_t k1) override;

    const FloatMips& m_mips;
    VertexAverages m_averages;
    Writable m_writable;
    std::size_t m_count = 0;
};

} // namespace trixel
