// SPDX-License-Identifier: GPL-3.0-or-later
//
// Every corner on its own: averages at mesh vertices are those of one face.
#include "core/mesh/vertex_rings.h"

namespace trixel {

VertexRings::VertexRings(const Adjacency& adjacency)
{
    m_begins.push_back(0);
    for (std::size_t place = 0; place < adjacency.faceCount() * 3; ++place) {
        m_rings.push_back(static_cast<RingId>(place));
        m_corners.push_back({faceId(place / 3), static_cast<std::uint8_t>(place % 3)});
        m_begins.push_back(static_cast<std::uint32_t>(place + 1));
        m_closed.push_back(false);
    }
}

} // namespace trixel
