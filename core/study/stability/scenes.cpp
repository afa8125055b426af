// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/stability/scenes.h"

#include <cmath>
#include <numbers>

namespace trixel::sweeps {

FilterScene sceneOf(const TriangleMesh& mesh,
                    const Adjacency& adjacency,
                    std::span<const Level> levels,
                    const TexelValue& value)
{
    check(levels.size() == mesh.faceCount(), "a level a face");
    const TexelFormat format{TexelType::Float, 1, std::nullopt};
    const float nothing = 0;
    TexelStore store(static_cast<std::uint32_t>(mesh.faceCount()),
                     format,
                     Level(0),
                     std::as_bytes(std::span(&nothing, 1)));
    for (std::size_t f = 0; f < mesh.faceCount(); ++f) {
        std::vector<float> texels(levels[f].texelCount());
        for (std::size_t t = 0; t < texels.size(); ++t) {
            texels[t] = value(faceId(f), levels[f], static_cast<TexelIndex>(t));
        }
        store.exchange(
            faceId(f),
            FaceTexels::full(levels[f], format.texelBytes(), std::as_bytes(std::span(texels))));
    }
    NoProgress progress;
    auto surface = std::make_shared<const FilterSurface>(FilterSurface::fromMesh(mesh, adjacency));
    return *FilterScene::build(std::move(surface), store, Threads{1}, progress);
}

FilterScene
sceneOf(const TriangleMesh& mesh, std::span<const Level> levels, const TexelValue& value)
{
    return sceneOf(mesh, buildAdjacency(mesh.triangles), levels, value);
}

FilterScene flatScene(Level level)
{
    TriangleMesh mesh;
    mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0.5F, static_cast<float>(std::numbers::sqrt3 / 2), 0}};
    mesh.triangles = {{0, 1, 2}};
    return sceneOf(mesh, std::span(&level, 1), [](FaceId, Level, TexelIndex) { return 0.5F; });
}

FilterScene pillowScene(float value)
{
    TriangleMesh mesh = pairOfFaces();
    mesh.triangles = {{0, 1, 2}, {0, 2, 1}};
    const std::array<Level, 2> levels{Level(9), Level(9)};
    return sceneOf(mesh, levels, [value](FaceId, Level, TexelIndex) { return value; });
}

TriangleMesh fan(int valence)
{
    TriangleMesh mesh;
    mesh.positions.emplace_back(0.0F);
    const auto count = static_cast<std::uint32_t>(valence);
    for (std::uint32_t k = 0; k < count; ++k) {
        const double angle = 2 * std::numbers::pi * k / count;
        mesh.positions.emplace_back(
            static_cast<float>(std::cos(angle)), static_cast<float>(std::sin(angle)), 0.0F);
        mesh.triangles.push_back({0, 1 + k, 1 + (k + 1) % count});
    }
    return mesh;
}

TriangleMesh pairOfFaces()
{
    const auto height = static_cast<float>(std::numbers::sqrt3 / 2);
    TriangleMesh mesh;
    mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0.5F, height, 0}, {1.5F, height, 0}};
    mesh.triangles = {{0, 1, 2}, {3, 2, 1}};
    return mesh;
}

} // namespace trixel::sweeps
