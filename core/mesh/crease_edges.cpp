// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/crease_edges.h"

#include <algorithm>
#include <array>

namespace trixel {

namespace {

using Edge = std::array<std::uint32_t, 2>;

Edge edgeOf(std::uint32_t a, std::uint32_t b)
{
    return {std::min(a, b), std::max(a, b)};
}

/// The edges between marked vertices, ascending.
std::vector<Edge> edgesBetween(const TriangleMesh& mesh, const std::vector<bool>& isMarked)
{
    std::vector<Edge> edges;
    for (const Triangle& t : mesh.triangles) {
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint32_t a = t[k];
            const std::uint32_t b = t[(k + 1) % 3];
            if (isMarked[a] && isMarked[b] && a != b) {
                edges.push_back(edgeOf(a, b));
            }
        }
    }
    std::ranges::sort(edges);
    return edges;
}

} // namespace

std::optional<std::size_t> firstOffEdges(const TriangleMesh& mesh, std::span<const Crease> creases)
{
    if (creases.empty()) {
        return std::nullopt;
    }
    std::vector<bool> isEnd(mesh.positions.size());
    for (const Crease& crease : creases) {
        isEnd[crease.from] = true;
        isEnd[crease.to] = true;
    }
    const std::vector<Edge> edges = edgesBetween(mesh, isEnd);
    const auto found = std::ranges::find_if(creases, [&](const Crease& crease) {
        return !std::ranges::binary_search(edges, edgeOf(crease.from, crease.to));
    });
    return found == creases.end()
               ? std::nullopt
               : std::optional(static_cast<std::size_t>(found - creases.begin()));
}

} // namespace trixel
