// SPDX-License-Identifier: GPL-3.0-or-later
//
// Scenes for tests of filters: closed meshes of any valence, flat lattices, noise of mixed levels.
#pragma once

#include "core/filter/filter_scene.h"

#include <algorithm>
#include <functional>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <map>
#include <random>
#include <set>

namespace trixel::test {

using Random = std::mt19937;

inline double unit(Random& random)
{
    return std::uniform_real_distribution<double>(0.0, 1.0)(random);
}

/// A sphere of triangles whose edges were flipped at random as long as every valence stays within
/// [3, 10], and whose vertices were moved: irregular in every way, closed.
inline TriangleMesh randomClosedMesh(Random& random, int subdivisions = 1, int flips = 60)
{
    TriangleMesh mesh;
    mesh.positions = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
    mesh.triangles = {
        {0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
    for (int s = 0; s < subdivisions; ++s) {
        std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
        const auto middle = [&](std::uint32_t a, std::uint32_t b) {
            const auto next = static_cast<std::uint32_t>(mesh.positions.size());
            const auto [at, fresh] = middles.emplace(std::minmax(a, b), next);
            if (fresh) {
                mesh.positions.push_back(glm::normalize(mesh.positions[a] + mesh.positions[b]));
            }
            return at->second;
        };
        std::vector<Triangle> finer;
        for (const auto& [a, b, c] : mesh.triangles) {
            const std::uint32_t ab = middle(a, b);
            const std::uint32_t bc = middle(b, c);
            const std::uint32_t ca = middle(c, a);
            finer.insert(finer.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
        }
        mesh.triangles = finer;
    }
    std::vector<int> valence(mesh.positions.size());
    std::set<std::pair<std::uint32_t, std::uint32_t>> edges;
    for (const Triangle& t : mesh.triangles) {
        for (std::size_t k = 0; k < 3; ++k) {
            ++valence[t[k]];
            edges.insert(std::minmax(t[k], t[(k + 1) % 3]));
        }
    }
    for (int flip = 0; flip < flips; ++flip) {
        const Adjacency adjacency = buildAdjacency(mesh.triangles);
        const auto f = static_cast<std::size_t>(unit(random) * double(mesh.faceCount()));
        const auto e = static_cast<std::size_t>(unit(random) * 3);
        const auto across = adjacency.neighbour(faceId(f), static_cast<LocalEdge>(e));
        Triangle& own = mesh.triangles[f];
        Triangle& other = mesh.triangles[indexOf(across->face)];
        const std::uint32_t a = own[e];
        const std::uint32_t b = own[(e + 1) % 3];
        const std::uint32_t top = own[(e + 2) % 3];
        const std::uint32_t low = other[(indexOf(across->edge) + 2) % 3];
        if (valence[a] <= 3 || valence[b] <= 3 || valence[top] >= 10 || valence[low] >= 10 ||
            edges.contains(std::minmax(top, low))) {
            continue;
        }
        edges.erase(std::minmax(a, b));
        edges.insert(std::minmax(top, low));
        --valence[a];
        --valence[b];
        ++valence[top];
        ++valence[low];
        own = {top, a, low};
        other = {low, b, top};
    }
    for (glm::vec3& position : mesh.positions) {
        position *= static_cast<float>(0.8 + 0.4 * unit(random));
    }
    for (Triangle& t : mesh.triangles) {
        std::rotate(t.begin(), t.begin() + static_cast<int>(unit(random) * 3), t.end());
    }
    return mesh;
}

/// A rhombus of the equilateral lattice, `cells` along a side, two faces a cell, in the plane.
inline TriangleMesh flatLattice(std::uint32_t cells)
{
    TriangleMesh mesh;
    for (std::uint32_t y = 0; y <= cells; ++y) {
        for (std::uint32_t x = 0; x <= cells; ++x) {
            mesh.positions.emplace_back(
                float(x) + 0.5F * float(y), 0.8660254037844386F * float(y), 0);
        }
    }
    const auto at = [&](std::uint32_t x, std::uint32_t y) { return x + y * (cells + 1); };
    for (std::uint32_t y = 0; y < cells; ++y) {
        for (std::uint32_t x = 0; x < cells; ++x) {
            mesh.triangles.push_back({at(x, y), at(x + 1, y), at(x, y + 1)});
            mesh.triangles.push_back({at(x + 1, y + 1), at(x, y + 1), at(x + 1, y)});
        }
    }
    return mesh;
}

/// Texels with value(face, centroid, channel), as floats.
inline TexelStore storeOf(const FaceMap<Level>& levels,
                          int channels,
                          const std::function<float(FaceId, glm::dvec2, int)>& value)
{
    const TexelFormat format{TexelType::Float, static_cast<std::uint16_t>(channels), std::nullopt};
    const std::vector<float> zero(static_cast<std::size_t>(channels));
    TexelStore store(format, levels, std::as_bytes(std::span(zero)));
    for (std::size_t f = 0; f < levels.size(); ++f) {
        const Level level = levels[faceId(f)];
        std::vector<float> texels;
        for (std::uint32_t t = 0; t < level.texelCount(); ++t) {
            const glm::dvec2 uv = centroid(level, texelAt(level, static_cast<TexelIndex>(t)));
            for (int c = 0; c < channels; ++c) {
                texels.push_back(value(faceId(f), uv, c));
            }
        }
        store.exchange(
            faceId(f),
            FaceTexels::full(level, format.texelBytes(), std::as_bytes(std::span(texels))));
    }
    return store;
}

inline FaceMap<Level> randomLevels(Random& random, std::size_t faces, int least, int most)
{
    FaceMap<Level> levels(faces);
    for (Level& level : levels.values()) {
        level = Level(least + static_cast<int>(unit(random) * (most - least + 1)));
    }
    return levels;
}

inline TexelStore noiseStore(Random& random, const FaceMap<Level>& levels, int channels)
{
    return storeOf(levels, channels, [&](FaceId, glm::dvec2, int) {
        return static_cast<float>(unit(random));
    });
}

inline FilterScene sceneOf(const TriangleMesh& mesh, const TexelStore& store)
{
    NoProgress progress;
    auto surface = std::make_shared<const FilterSurface>(
        FilterSurface::fromMesh(mesh, buildAdjacency(mesh.triangles)));
    return *FilterScene::build(surface, store, Threads{1}, progress);
}

} // namespace trixel::test
