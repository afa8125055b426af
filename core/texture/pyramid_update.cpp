// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/texture/pyramid_update.h"

namespace trixel {

void PyramidUpdate::row(
    FaceId face, Level level, std::uint32_t j, std::uint32_t i0, std::uint32_t i1)
{
    m_count += m_averages.row(face, level, j, i0, i1, m_writable(face, level));
}

void PyramidUpdate::edge(FaceId face, LocalEdge edge, Level level, std::uint32_t k)
{
    m_averages.onEdgeOf(face, edge, level, k, m_writable(face, level));
    ++m_count;
}

void PyramidUpdate::corner(FaceId face, std::uint8_t corner, Level ringBase, Level level)
{
    m_averages.atCorner(face, corner, ringBase, level, m_writable(face, level));
    ++m_count;
}

void PyramidUpdate::derived(
    FaceId face, LocalEdge edge, Level base, Level level, std::uint32_t k0, std::uint32_t k1)
{
    const float* baseValues = m_writable(face, base);
    float* values = m_writable(face, level);
    for (std::uint32_t k = k0; k <= k1; ++k) {
        VertexAverages::derive(edge, base, baseValues, level, k, values);
        ++m_count;
    }
}

} // namespace trixel
