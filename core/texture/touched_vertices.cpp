// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/texture/touched_vertices.h"

#include <algorithm>

namespace trixel {

std::vector<VertexRun> TouchedVertices::take(std::uint32_t gap)
{
    derive();
    std::vector<std::uint32_t> faces;
    faces.reserve(m_runs.size());
    for (const auto& [face, runs] : m_runs) {
        faces.push_back(face);
    }
    std::ranges::sort(faces);
    std::vector<VertexRun> taken;
    for (const std::uint32_t face : faces) {
        std::vector<Run>& runs = m_runs[face];
        std::ranges::sort(runs, {}, &Run::first);
        for (std::size_t begin = 0, next = 0; begin < runs.size(); begin = next) {
            std::uint32_t end = runs[begin].end;
            for (next = begin + 1; next < runs.size() && runs[next].first <= end + gap; ++next) {
                end = std::max(end, runs[next].end);
            }
            taken.push_back({faceId(face), runs[begin].first, end - runs[begin].first});
        }
    }
    m_runs.clear();
    return taken;
}

void TouchedVertices::add(FaceId face, Level level, LatticePoint at, std::uint32_t count)
{
    const std::uint32_t first =
        vertexBlockBegin(level) + static_cast<std::uint32_t>(latticeVertex(level, at.i, at.j));
    m_runs[static_cast<std::uint32_t>(face)].push_back({first, first + count});
}

void TouchedVertices::row(
    FaceId face, Level level, std::uint32_t j, std::uint32_t i0, std::uint32_t i1)
{
    const std::uint32_t r = level.resolution();
    if (j == 0 || j + 1 >= r) {
        return;
    }
    i0 = std::max(i0, 1U);
    i1 = std::min(i1, r - 1 - j);
    if (i0 <= i1) {
        add(face, level, {i0, j}, i1 - i0 + 1);
    }
}

void TouchedVertices::edge(FaceId face, LocalEdge edge, Level level, std::uint32_t k)
{
    add(face, level, onEdge(level, edge, k), 1);
}

void TouchedVertices::corner(FaceId face, std::uint8_t corner, Level /*ringBase*/, Level level)
{
    add(face, level, onEdge(level, static_cast<LocalEdge>(corner), 0), 1);
}

void TouchedVertices::derived(
    FaceId face, LocalEdge edge, Level /*base*/, Level level, std::uint32_t k0, std::uint32_t k1)
{
    for (std::uint32_t k = k0; k <= k1; ++k) {
        add(face, level, onEdge(level, edge, k), 1);
    }
}

} // namespace trixel
