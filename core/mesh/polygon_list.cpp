// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/polygon_list.h"

namespace trixel {

void PolygonList::addPolygon(std::span<const std::uint32_t> corners)
{
    if (!m_triangles.empty()) {
        m_corners.reserve(4 * m_triangles.size());
        for (const Triangle& t : m_triangles) {
            m_corners.insert(m_corners.end(), t.begin(), t.end());
        }
        m_sizes.assign(m_triangles.size(), 3);
        m_triangles = {};
    }
    m_corners.insert(m_corners.end(), corners.begin(), corners.end());
    m_sizes.push_back(static_cast<std::uint32_t>(corners.size()));
}

} // namespace trixel
