// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace trixel {

/// Polygons as a file lists them: the vertex numbers of one after the other.
class PolygonList
{
public:
    void reserve(std::size_t corners) { m_corners.reserve(corners); }

    void addCorner(std::uint32_t vertex) { m_corners.push_back(vertex); }

    /// Ends a polygon of the `corners` corners added last, at least three.
    void closePolygon(std::size_t corners)
    {
        if (corners != 3 && m_sizes.empty()) {
            m_sizes.assign(m_count, 3);
        }
        if (corners != 3 || !m_sizes.empty()) {
            m_sizes.push_back(static_cast<std::uint32_t>(corners));
        }
        ++m_count;
    }

    std::size_t count() const { return m_count; }
    bool allTriangles() const { return m_sizes.empty(); }
    std::size_t triangleCount() const { return m_corners.size() - 2 * m_count; }

    const std::vector<std::uint32_t>& corners() const { return m_corners; }
    std::size_t sizeOf(std::size_t polygon) const { return m_sizes.empty() ? 3 : m_sizes[polygon]; }

private:
    std::vector<std::uint32_t> m_corners;
    std::vector<std::uint32_t> m_sizes; // empty while all are triangles
    std::size_t m_count = 0;
};

} // namespace trixel
