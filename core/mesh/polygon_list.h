// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/triangle_mesh.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace trixel {

/// Polygons as a file lists them, kept compact while all are triangles.
class PolygonList
{
public:
    /// Room for so many triangles.
    void reserve(std::size_t triangles) { m_triangles.reserve(triangles); }

    /// \param corners  vertex numbers, at least three
    void add(std::span<const std::uint32_t> corners)
    {
        if (corners.size() == 3 && allTriangles()) {
            m_triangles.push_back({corners[0], corners[1], corners[2]});
        } else {
            addPolygon(corners);
        }
    }

    std::size_t count() const { return allTriangles() ? m_triangles.size() : m_sizes.size(); }
    std::size_t triangleCount() const
    {
        return allTriangles() ? m_triangles.size() : m_corners.size() - 2 * m_sizes.size();
    }

    bool allTriangles() const { return m_sizes.empty(); }
    /// All of them where all are triangles, otherwise none.
    std::vector<Triangle>& triangles() { return m_triangles; }

    /// Where not all are triangles: corners of each polygon, and all corners one after the other.
    const std::vector<std::uint32_t>& sizes() const { return m_sizes; }
    const std::vector<std::uint32_t>& corners() const { return m_corners; }

private:
    void addPolygon(std::span<const std::uint32_t> corners);

    std::vector<Triangle> m_triangles; // while all are
    std::vector<std::uint32_t> m_sizes;
    std::vector<std::uint32_t> m_corners;
};

} // namespace trixel
