// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

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
    std::optional<EdgeNeighbour> neighbour(FaceId face, LocalEdge edge) const;

    /// Records both sides of a shared edge.
    void connect(FaceId a, LocalEdge edgeOfA, FaceId b, LocalEdge edgeOfB);

    bool operator==(const Adjacency&) const = default;

private:
    // face << 2 | edge; all ones at a border.
    std::vector<std::uint32_t> m_neighbours;
};

/// Adjacency of the triangles as they stand (no vertex is merged).
Adjacency buildAdjacency(std::span<const Triangle> triangles);

} // namespace trixel
