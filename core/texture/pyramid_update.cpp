// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/texture/pyramid_update.h"

#include <algorithm>
#include <tuple>

namespace trixel {

void PyramidUpdate::touch(FaceId face, const TouchedRect& rect)
{
    TouchedCells cells(m_mips.level(face), rect);
    for (Level level = m_mips.level(face);; level = level.coarser()) {
        for (std::size_t k = 0; k < cells.count; ++k) {
            touchCells(face, level, cells.rects[k]);
        }
        if (level == Level(0)) {
            return;
        }
        cells = cells.coarser();
    }
}

void PyramidUpdate::touchCells(FaceId face, Level level, const CellRect& cells)
{
    const std::uint32_t r = level.resolution();
    // Vertices about the cells' texels.
    const std::uint32_t i1 = std::min(cells.i1 + 1, r);
    const std::uint32_t j1 = std::min(cells.j1 + 1, r);
    float* values = m_writable(face, level);
    for (std::uint32_t j = cells.j0; j <= j1; ++j) {
        m_count += m_averages.row(face, level, j, cells.i0, i1, values);
    }
    if (cells.j0 == 0) {
        touchEdge(face, LocalEdge::E0, level, cells.i0, i1);
    }
    if (cells.i0 == 0) {
        touchEdge(face, LocalEdge::E2, level, r - j1, r - cells.j0);
    }
    if (i1 + j1 >= r) { // the corner farthest out reaches the hypotenuse, where i = r - k, j = k
        const std::uint32_t k0 = std::max(cells.j0, r - i1);
        const std::uint32_t k1 = std::min(j1, r - cells.i0);
        if (k0 <= k1) {
            touchEdge(face, LocalEdge::E1, level, k0, k1);
        }
    }
}

void PyramidUpdate::touchEdge(
    FaceId face, LocalEdge edge, Level level, std::uint32_t k0, std::uint32_t k1)
{
    const std::uint32_t r = level.resolution();
    if (k0 == 0) {
        touchCorner(face, static_cast<std::uint8_t>(edge), level);
    }
    if (k1 == r) {
        touchCorner(face, static_cast<std::uint8_t>(nextEdge(edge)), level);
    }
    const Level base = m_averages.edgeBase(face, edge);
    if (level > base) {
        return; // derived
    }
    const auto across = m_adjacency.neighbour(face, edge);
    for (std::uint32_t k = std::max(k0, 1U); k <= std::min(k1, r - 1); ++k) {
        m_averages.onEdgeOf(face, edge, level, k, m_writable(face, level));
        ++m_count;
        if (across) {
            float* values = m_writable(across->face, level);
            m_averages.onEdgeOf(across->face, across->edge, level, r - k, values);
            ++m_count;
        }
    }
    if (level == base && m_mips.level(face) > base) {
        m_spans.push_back({face, edge, base, k0, k1});
    }
    if (level == base && across && m_mips.level(across->face) > base) {
        m_spans.push_back({across->face, across->edge, base, r - k1, r - k0});
    }
}

void PyramidUpdate::touchCorner(FaceId face, std::uint8_t corner, Level level)
{
    const Level ringBase = m_averages.ringBase(face, corner);
    if (level > ringBase) {
        return;
    }
    for (const Corner& other : m_rings.corners(m_rings.ring({face, corner}))) {
        const Level own = m_mips.level(other.face);
        const Level last = level == ringBase ? own : level;
        for (Level n = level; n <= last; n = Level(n.log2() + 1)) {
            m_averages.atCorner(other.face, other.index, ringBase, n, m_writable(other.face, n));
            ++m_count;
            if (n == Level(Level::kMax)) {
                break;
            }
        }
        // Edges that end here and are derived from a level that changed.
        const auto starts = static_cast<LocalEdge>(other.index);
        const auto ends = static_cast<LocalEdge>((other.index + 2) % 3);
        for (const LocalEdge edge : {starts, ends}) {
            const Level base = m_averages.edgeBase(other.face, edge);
            if (base < own && base >= level && base <= last) {
                const std::uint32_t k = edge == starts ? 0 : base.resolution();
                m_spans.push_back({other.face, edge, base, k, k});
            }
        }
    }
}

void PyramidUpdate::derive()
{
    // Corners are touched from both sides: what overlaps is derived once.
    const auto order = [](const Span& span) {
        return std::tuple(span.face, span.edge, span.base, span.k0);
    };
    std::ranges::sort(m_spans, {}, order);
    for (std::size_t begin = 0, end = 0; begin < m_spans.size(); begin = end) {
        Span joined = m_spans[begin];
        for (end = begin + 1; end < m_spans.size(); ++end) {
            const Span& next = m_spans[end];
            if (next.face != joined.face || next.edge != joined.edge || next.base != joined.base ||
                next.k0 > joined.k1 + 2) { // each reaches one further
                break;
            }
            joined.k1 = std::max(joined.k1, next.k1);
        }
        deriveSpan(joined);
    }
    m_spans.clear();
}

void PyramidUpdate::deriveSpan(const Span& span)
{
    const std::uint32_t from = span.k0 == 0 ? 0 : span.k0 - 1;
    const std::uint32_t to = std::min(span.k1 + 1, span.base.resolution());
    const float* baseValues = m_writable(span.face, span.base);
    for (int n = span.base.log2() + 1; n <= m_mips.level(span.face).log2(); ++n) {
        const Level level(n);
        const int steps = n - span.base.log2();
        float* values = m_writable(span.face, level);
        const std::uint32_t last = std::min((to << steps), level.resolution() - 1);
        for (std::uint32_t k = std::max(from << steps, 1U); k <= last; ++k) {
            VertexAverages::derive(span.edge, span.base, baseValues, level, k, values);
            ++m_count;
        }
    }
}

} // namespace trixel
