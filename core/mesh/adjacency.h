// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/check.h"
#include "core/mesh/triangle_mesh.h"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace trixel {

/// The other side of an edge: the neighbouring face and the number it gives the shared edge.
struct EdgeNeighbour
{
    FaceId face{};
    LocalEdge edge{};

    bool operator==(const EdgeNeighbour&) const = default;
};

/// Neighbours across the three edges of every face, in Ptex terms. Symmetric: if A's edge e meets
/// B's edge f, then B's f meets A's e. Two faces are neighbours where exactly two faces share an
/// edge and run along it in opposite directions; every other edge is a border. A face that repeats
/// a vertex has no edges to share: it is all borders and never comes between its neighbours.
class Adjacency
{
public:
    Adjacency() = default;
    explicit Adjacency(std::size_t faceCount);

    std::size_t faceCount() const { return m_neighbours.size() / 3; }

    /// Nothing at a border.
    std::optional<EdgeNeighbour> neighbour(FaceId face, LocalEdge edge) const
    {
        check(indexOf(face) < faceCount(), "face exists");
        const std::uint32_t other = m_neighbours[3 * indexOf(face) + indexOf(edge)];
        return other == kBorder ? std::nullopt
                                : std::optional(EdgeNeighbour{faceId(other >> 2U),
                                                              static_cast<LocalEdge>(other & 3U)});
    }

    /// Records both sides of a shared edge.
    void connect(FaceId a, LocalEdge edgeOfA, FaceId b, LocalEdge edgeOfB);

    bool operator==(const Adjacency&) const = default;

private:
    static constexpr std::uint32_t kBorder = 0xFFFFFFFFU;

    // face << 2 | edge, or kBorder.
    std::vector<std::uint32_t> m_neighbours;
};

/// Adjacency of the triangles as they stand (no vertex is merged).
Adjacency buildAdjacency(std::span<const Triangle> triangles);

} // namespace trixel
