// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/adjacency.h"

#include <cstdint>
#include <span>
#include <vector>

namespace trixel {

/// Number of a ring: see `VertexRings`.
enum class RingId : std::uint32_t {};

constexpr std::size_t indexOf(RingId id)
{
    return static_cast<std::size_t>(id);
}

/// Corner of a face: 0 is V0, 1 is V1, 2 is V2.
struct Corner
{
    FaceId face{};
    std::uint8_t index = 0;

    bool operator==(const Corner&) const = default;
};

/// The corners that meet at every vertex, found by walking across edges. Faces that only touch at
/// a vertex without being connected across edges around it are in different rings, as Ptex has it:
/// texels are shared across edges alone. Needs no vertex numbers, so that a .ptx without its mesh
/// has rings too.
class VertexRings
{
public:
    VertexRings() = default;
    explicit VertexRings(const Adjacency& adjacency);

    std::size_t ringCount() const { return m_begins.empty() ? 0 : m_begins.size() - 1; }

    RingId ring(Corner corner) const
    {
        check(indexOf(corner.face) * 3 + corner.index < m_rings.size(), "corner exists");
        return m_rings[indexOf(corner.face) * 3 + corner.index];
    }

    /// In counter-clockwise order; from the border on where the ring is open, else from the corner
    /// of the lowest face.
    std::span<const Corner> corners(RingId ring) const
    {
        check(indexOf(ring) < ringCount(), "ring exists");
        const std::size_t begin = m_begins[indexOf(ring)];
        return std::span(m_corners).subspan(begin, m_begins[indexOf(ring) + 1] - begin);
    }

    /// Whether the faces surround the vertex without a border between them.
    bool isClosed(RingId ring) const { return m_closed[indexOf(ring)]; }

private:
    std::vector<RingId> m_rings;         // three a face
    std::vector<std::uint32_t> m_begins; // of each ring in m_corners; one more at the end
    std::vector<Corner> m_corners;
    std::vector<bool> m_closed;
};

} // namespace trixel
