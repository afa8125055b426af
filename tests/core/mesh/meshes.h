// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/triangle_mesh.h"

#include <random>

namespace trixel::test {

/// A flat grid of n × n squares of two triangles each, in the plane z = 0.
inline TriangleMesh gridMesh(std::uint32_t n)
{
    TriangleMesh mesh;
    for (std::uint32_t y = 0; y <= n; ++y) {
        for (std::uint32_t x = 0; x <= n; ++x) {
            mesh.positions.emplace_back(static_cast<float>(x), static_cast<float>(y), 0.0F);
        }
    }
    for (std::uint32_t y = 0; y < n; ++y) {
        for (std::uint32_t x = 0; x < n; ++x) {
            const std::uint32_t a = y * (n + 1) + x;
            mesh.triangles.push_back({a, a + 1, a + n + 1});
            mesh.triangles.push_back({a + 1, a + n + 2, a + n + 1});
        }
    }
    return mesh;
}

/// A closed tetrahedron whose four vertices start at `first`.
inline void addTetrahedron(TriangleMesh& mesh, const std::array<std::uint32_t, 4>& v)
{
    mesh.triangles.push_back({v[0], v[2], v[1]});
    mesh.triangles.push_back({v[0], v[1], v[3]});
    mesh.triangles.push_back({v[1], v[2], v[3]});
    mesh.triangles.push_back({v[2], v[0], v[3]});
}

inline TriangleMesh tetrahedron()
{
    TriangleMesh mesh;
    mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    addTetrahedron(mesh, {0, 1, 2, 3});
    return mesh;
}

/// Triangles over few vertices, so that every fault occurs: repeated vertices, duplicates, edges of
/// many faces, flipped faces, rings that touch.
inline TriangleMesh messyMesh(std::uint32_t vertices, std::size_t faces, unsigned seed)
{
    std::mt19937 random(seed);
    std::uniform_int_distribution<std::uint32_t> vertex(0, vertices - 1);
    std::uniform_real_distribution<float> coordinate(-1.0F, 1.0F);
    TriangleMesh mesh;
    for (std::uint32_t v = 0; v < vertices; ++v) {
        mesh.positions.emplace_back(coordinate(random), coordinate(random), coordinate(random));
    }
    for (std::size_t f = 0; f < faces; ++f) {
        mesh.triangles.push_back({vertex(random), vertex(random), vertex(random)});
    }
    return mesh;
}

} // namespace trixel::test
