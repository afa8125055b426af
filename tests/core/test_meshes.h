// SPDX-License-Identifier: GPL-3.0-or-later
//
// Small meshes made on the spot, for tests and benchmarks.
#pragma once

#include "core/mesh/triangle_mesh.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <map>
#include <random>
#include <utility>
#include <vector>

namespace trixel::test {

/// A flat square of side 1 in z = 0, facing +z, of 2 n² triangles.
inline TriangleMesh gridMesh(std::uint32_t n)
{
    TriangleMesh mesh;
    for (std::uint32_t y = 0; y <= n; ++y) {
        for (std::uint32_t x = 0; x <= n; ++x) {
            mesh.positions.emplace_back(static_cast<float>(x) / static_cast<float>(n),
                                        static_cast<float>(y) / static_cast<float>(n),
                                        0.0F);
        }
    }
    for (std::uint32_t y = 0; y < n; ++y) {
        for (std::uint32_t x = 0; x < n; ++x) {
            const std::uint32_t a = y * (n + 1) + x;
            mesh.triangles.push_back({a, a + 1, a + n + 1});
            mesh.triangles.push_back({a + n + 2, a + n + 1, a + 1});
        }
    }
    return mesh;
}

/// A fan of triangles around the origin, facing +z, closed all round; corners at distance 1.
inline TriangleMesh fanMesh(std::uint32_t valence)
{
    TriangleMesh mesh;
    mesh.positions.emplace_back(0.0F);
    for (std::uint32_t k = 0; k < valence; ++k) {
        const double angle = 6.283185307179586 * k / valence;
        mesh.positions.emplace_back(
            static_cast<float>(std::cos(angle)), static_cast<float>(std::sin(angle)), 0.0F);
        mesh.triangles.push_back({0, 1 + k, 1 + (k + 1) % valence});
    }
    return mesh;
}

/// A sphere of radius 1 of 20 · 4^steps triangles, facing outwards.
inline TriangleMesh sphereMesh(int steps)
{
    const float g = 1.618034F;
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
    for (glm::vec3& p : mesh.positions) {
        p = glm::normalize(p);
    }
    mesh.triangles = {{0, 11, 5}, {0, 5, 1},  {0, 1, 7},   {0, 7, 10}, {0, 10, 11},
                      {1, 5, 9},  {5, 11, 4}, {11, 10, 2}, {10, 7, 6}, {7, 1, 8},
                      {3, 9, 4},  {3, 4, 2},  {3, 2, 6},   {3, 6, 8},  {3, 8, 9},
                      {4, 9, 5},  {2, 4, 11}, {6, 2, 10},  {8, 6, 7},  {9, 8, 1}};
    for (int step = 0; step < steps; ++step) {
        std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
        const auto middle = [&](std::uint32_t a, std::uint32_t b) {
            const auto next = static_cast<std::uint32_t>(mesh.positions.size());
            const auto [place, isNew] = middles.try_emplace(std::minmax(a, b), next);
            if (isNew) {
                mesh.positions.push_back(glm::normalize(mesh.positions[a] + mesh.positions[b]));
            }
            return place->second;
        };
        std::vector<Triangle> finer;
        for (const auto& [a, b, c] : mesh.triangles) {
            const std::uint32_t ab = middle(a, b);
            const std::uint32_t bc = middle(b, c);
            const std::uint32_t ca = middle(c, a);
            finer.insert(finer.end(), {{a, ab, ca}, {b, bc, ab}, {c, ca, bc}, {ab, bc, ca}});
        }
        mesh.triangles = std::move(finer);
    }
    return mesh;
}

/// Triangles of all sizes thrown at random into [-1,1]³; every eighth is degenerate (a repeated
/// corner, three corners on a line, or a point).
inline TriangleMesh soupMesh(std::size_t faces, std::uint32_t seed)
{
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> place(-1.0F, 1.0F);
    TriangleMesh mesh;
    const auto add = [&](glm::vec3 p) {
        mesh.positions.push_back(p);
        return static_cast<std::uint32_t>(mesh.positions.size() - 1);
    };
    const auto randomPoint = [&] {
        const float x = place(random);
        const float y = place(random);
        return glm::vec3(x, y, place(random));
    };
    for (std::size_t k = 0; k < faces; ++k) {
        const glm::vec3 a = randomPoint();
        const float size = std::exp2(4.0F * place(random) - 4.0F);
        const glm::vec3 b = a + size * randomPoint();
        const glm::vec3 c = a + size * randomPoint();
        if (k % 8 != 7) {
            mesh.triangles.push_back({add(a), add(b), add(c)});
        } else if (k % 24 == 7) {
            const std::uint32_t twice = add(a);
            mesh.triangles.push_back({twice, twice, add(b)});
        } else if (k % 24 == 15) {
            mesh.triangles.push_back({add(a), add(a + 0.5F * (b - a)), add(b)});
        } else {
            const std::uint32_t thrice = add(a);
            mesh.triangles.push_back({thrice, thrice, thrice});
        }
    }
    return mesh;
}

} // namespace trixel::test
