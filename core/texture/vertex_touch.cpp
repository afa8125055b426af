// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/texture/vertex_touch.h"

#include <algorithm>
#include <tuple>

namespace trixel {

void VertexTouch::touch(FaceId face, Level base, const TouchedRect& rect)
{
    const Level own = m_level(face);
    TouchedCells cells(base, rect);
    for (Level level = base;; level = level.coarser()) {
        for (std::size_t k = 0; k < cells.count && level <= own; ++k) {
            touchCells(face, level, cells.rects[k]);
        }
        if (level == Level(0)) {
            return;
        }
        cells = cells.coarser();
    }
}

void VertexTouch::touchCells(FaceId face, Level level, const CellRect& cells)
{
    const std::uint32_t r = level.resolution();
    // Vertices about the cells' texels.
    const std::uint32_t i1 = std::min(cells.i1 + 1, r);
    const std::uint32_t j1 = std::min(cells.j1 + 1, r);
    for (std::uint32_t j = cells.j0; j <= j1; ++j) {
        row(face, level, j, cells.i0, i1);
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

void VertexTouch::touchEdge(
    FaceId face, LocalEdge touched, Level level, std::uint32_t k0, std::uint32_t k1)
{
    const std::uint32_t r = level.resolution();
    if (k0 == 0) {
        touchCorner(face, static_cast<std::uint8_t>(touched), level);
    }
    if (k1 == r) {
        touchCorner(face, static_cast<std::uint8_t>(nextEdge(touched)), level);
    }
    const Level base = edgeBase(face, touched);
    if (level > base) {
        return; // derived
    }
    const auto across = m_adjacency.neighbour(face, touched);
    for (std::uint32_t k = std::max(k0, 1U); k <= std::min(k1, r - 1); ++k) {
        edge(face, touched, level, k);
        if (across) {
            edge(across->face, across->edge, level, r - k);
        }
    }
    if (level == base && m_level(face) > base) {
        m_spans.push_back({face, touched, base, k0, k1});
    }
    if (level == base && across && m_level(across->face) > base) {
        m_spans.push_back({across->face, across->edge, base, r - k1, r - k0});
    }
}

void VertexTouch::touchCorner(FaceId face, std::uint8_t touched, Level level)
{
    const Level least = ringBase(face, touched);
    if (level > least) {
        return;
    }
    for (const Corner& other : m_rings.corners(m_rings.ring({face, touched}))) {
        const Level own = m_level(other.face);
        const Level last = level == least ? own : level;
        for (Level n = level; n <= last; n = Level(n.log2() + 1)) {
            corner(other.face, other.index, least, n);
            if (n == Level(Level::kMax)) {
                break;
            }
        }
        // Edges that end here and are derived from a level that changed.
        const auto starts = static_cast<LocalEdge>(other.index);
        const auto ends = static_cast<LocalEdge>((other.index + 2) % 3);
        for (const LocalEdge edge : {starts, ends}) {
            const Level base = edgeBase(other.face, edge);
            if (base < own && base >= level && base <= last) {
                const std::uint32_t k = edge == starts ? 0 : base.resolution();
                m_spans.push_back({other.face, edge, base, k, k});
            }
        }
    }
}

void VertexTouch::derive()
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

void VertexTouch::deriveSpan(const Span& span)
{
    const std::uint32_t from = span.k0 == 0 ? 0 : span.k0 - 1;
    const std::uint32_t to = std::min(span.k1 + 1, span.base.resolution());
    for (int n = span.base.log2() + 1; n <= m_level(span.face).log2(); ++n) {
        const Level level(n);
        const int steps = n - span.base.log2();
        const std::uint32_t first = std::max(from << steps, 1U);
        const std::uint32_t last = std::min(to << steps, level.resolution() - 1);
        derived(span.face, span.edge, span.base, level, first, last);
    }
}

Level VertexTouch::edgeBase(FaceId face, LocalEdge edge) const
{
    const auto across = m_adjacency.neighbour(face, edge);
    return across ? std::min(m_level(face), m_level(across->face)) : m_level(face);
}

Level VertexTouch::ringBase(FaceId face, std::uint8_t corner) const
{
    Level coarsest(Level::kMax);
    for (const Corner& other : m_rings.corners(m_rings.ring({face, corner}))) {
        coarsest = std::min(coarsest, m_level(other.face));
    }
    return coarsest;
}

} // namespace trixel
