// SPDX-License-Identifier: GPL-3.0-or-later
//
// Cages for subdivision: solids about the origin, and fans.
#pragma once

#include "core/mesh/triangle_mesh.h"

#include <cmath>
#include <numbers>

namespace trixel::test {

inline TriangleMesh regularTetrahedron()
{
    TriangleMesh mesh;
    mesh.positions = {{1, 1, 1}, {-1, -1, 1}, {-1, 1, -1}, {1, -1, -1}};
    mesh.triangles = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
    return mesh;
}

inline TriangleMesh octahedron()
{
    TriangleMesh mesh;
    mesh.positions = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
    mesh.triangles = {
        {0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
    return mesh;
}

inline TriangleMesh icosahedron()
{
    const float g = std::numbers::phi_v<float>;
    TriangleMesh mesh;
    mesh.positions = {{-1, g, 0},
                      {1, g, 0},
                      {-1, -g, 0},
                      {1, -g, 0},
                      {0, -1, g},
                      {0, 1, g},
                      {0, -1, -g},
                      {0, 1, -g},
                      {g, 0, -1},
                      {g, 0, 1},
                      {-g, 0, -1},
                      {-g, 0, 1}};
    mesh.triangles = {{0, 11, 5}, {0, 5, 1},  {0, 1, 7},   {0, 7, 10}, {0, 10, 11},
                      {1, 5, 9},  {5, 11, 4}, {11, 10, 2}, {10, 7, 6}, {7, 1, 8},
                      {3, 9, 4},  {3, 4, 2},  {3, 2, 6},   {3, 6, 8},  {3, 8, 9},
                      {4, 9, 5},  {2, 4, 11}, {6, 2, 10},  {8, 6, 7},  {9, 8, 1}};
    return mesh;
}

/// Eight vertices at ±1, two triangles a side; vertex 4 z + 2 y + x.
inline TriangleMesh cube()
{
    TriangleMesh mesh;
    for (int k = 0; k < 8; ++k) {
        mesh.positions.emplace_back(k & 1 ? 1 : -1, k & 2 ? 1 : -1, k & 4 ? 1 : -1);
    }
    mesh.triangles = {{0, 2, 3},
                      {0, 3, 1},
                      {4, 5, 7},
                      {4, 7, 6},
                      {0, 1, 5},
                      {0, 5, 4},
                      {2, 6, 7},
                      {2, 7, 3},
                      {0, 4, 6},
                      {0, 6, 2},
                      {1, 3, 7},
                      {1, 7, 5}};
    return mesh;
}

/// A hexagon of triangles around a raised centre (vertex 0).
inline TriangleMesh hexagon(float height)
{
    TriangleMesh mesh;
    mesh.positions = {{0, 0, height}};
    for (std::uint32_t k = 0; k < 6; ++k) {
        const float angle = static_cast<float>(k) * std::numbers::pi_v<float> / 3;
        mesh.positions.emplace_back(std::cos(angle), std::sin(angle), 0);
        mesh.triangles.push_back({0, 1 + k, 1 + (k + 1) % 6});
    }
    return mesh;
}

/// `valence` triangles around a raised centre (vertex 0).
inline TriangleMesh fan(std::uint32_t valence)
{
    TriangleMesh mesh;
    mesh.positions = {{0, 0, 1}};
    for (std::uint32_t k = 0; k < valence; ++k) {
        const float angle =
            static_cast<float>(k) * 2 * std::numbers::pi_v<float> / static_cast<float>(valence);
        mesh.positions.emplace_back(std::cos(angle), std::sin(angle), 0);
        mesh.triangles.push_back({0, 1 + k, 1 + (k + 1) % valence});
    }
    return mesh;
}

/// A closed solid with two poles of a valence (vertices 0 and 1) over a ring of vertices of four
/// faces each.
inline TriangleMesh bipyramid(std::uint32_t valence)
{
    TriangleMesh mesh;
    mesh.positions = {{0, 0, 1}, {0, 0, -1}};
    for (std::uint32_t k = 0; k < valence; ++k) {
        const float angle =
            static_cast<float>(k) * 2 * std::numbers::pi_v<float> / static_cast<float>(valence);
        mesh.positions.emplace_back(std::cos(angle), std::sin(angle), 0);
        const std::uint32_t here = 2 + k;
        const std::uint32_t next = 2 + (k + 1) % valence;
        mesh.triangles.push_back({0, here, next});
        mesh.triangles.push_back({1, next, here});
    }
    return mesh;
}

} // namespace trixel::test
