// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/vertex_rings.h"

#include <limits>
#include <optional>

namespace trixel {
namespace {

constexpr RingId kNoRing{std::numeric_limits<std::uint32_t>::max()};

/// Corner k starts edge k and ends edge k + 2; the neighbour runs along a shared edge the other
/// way, so its corner there ends the edge on one side and starts it on the other.
std::optional<Corner> counterClockwise(const Adjacency& adjacency, Corner corner)
{
    const auto across =
        adjacency.neighbour(corner.face, static_cast<LocalEdge>((corner.index + 2) % 3));
    if (!across) {
        return std::nullopt;
    }
    return Corner{across->face, static_cast<std::uint8_t>(across->edge)};
}

std::optional<Corner> clockwise(const Adjacency& adjacency, Corner corner)
{
    const auto across = adjacency.neighbour(corner.face, static_cast<LocalEdge>(corner.index));
    if (!across) {
        return std::nullopt;
    }
    return Corner{across->face, static_cast<std::uint8_t>(nextEdge(across->edge))};
}

/// The most clockwise corner of the ring, or `corner` itself when the ring is closed.
Corner firstOf(const Adjacency& adjacency, Corner corner)
{
    Corner first = corner;
    while (const auto next = clockwise(adjacency, first)) {
        if (*next == corner) {
            return corner;
        }
        first = *next;
    }
    return first;
}

} // namespace

VertexRings::VertexRings(const Adjacency& adjacency)
    : m_rings(adjacency.faceCount() * 3, kNoRing)
{
    m_begins.push_back(0);
    m_corners.reserve(m_rings.size());
    for (std::size_t place = 0; place < m_rings.size(); ++place) {
        if (m_rings[place] != kNoRing) {
            continue;
        }
        const auto ring = static_cast<RingId>(ringCount());
        const Corner first =
            firstOf(adjacency, {faceId(place / 3), static_cast<std::uint8_t>(place % 3)});
        std::optional<Corner> corner = first;
        do {
            m_rings[indexOf(corner->face) * 3 + corner->index] = ring;
            m_corners.push_back(*corner);
            corner = counterClockwise(adjacency, *corner);
        } while (corner && *corner != first);
        m_closed.push_back(corner.has_value());
        m_begins.push_back(static_cast<std::uint32_t>(m_corners.size()));
    }
}

} // namespace trixel
