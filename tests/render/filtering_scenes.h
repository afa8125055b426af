// SPDX-License-Identifier: GPL-3.0-or-later
//
// Scenes that ways of filtering are looked at in: a torus of mixed levels, and the bunny.
#pragma once

#include "core/lattice/texel.h"
#include "core/mesh/mesh_reader.h"
#include "core/mesh/surface.h"
#include "core/study/solid_texture.h"
#include "core/texture/texel_store.h"
#include "render/corner_normals.h"
#include "render/filter_mesh.h"
#include "render/renderer.h"

#include <cmath>
#include <memory>
#include <random>

namespace trixel::render {

/// Around about 4 `rounds` and through 3 `rounds` quadrilaterals, each cut in two.
inline TriangleMesh torusMesh(std::uint32_t around, std::uint32_t through)
{
    TriangleMesh mesh;
    constexpr float kTurn = 6.2831853F;
    for (std::uint32_t a = 0; a < around; ++a) {
        for (std::uint32_t t = 0; t < through; ++t) {
            const float alpha = kTurn * static_cast<float>(a) / static_cast<float>(around);
            const float beta = kTurn * static_cast<float>(t) / static_cast<float>(through);
            const float r = 1 + 0.45F * std::cos(beta);
            mesh.positions.emplace_back(
                r * std::cos(alpha), r * std::sin(alpha), 0.45F * std::sin(beta));
        }
    }
    const auto at = [&](std::uint32_t a, std::uint32_t t) {
        return (a % around) * through + t % through;
    };
    for (std::uint32_t a = 0; a < around; ++a) {
        for (std::uint32_t t = 0; t < through; ++t) {
            mesh.triangles.push_back({at(a, t), at(a + 1, t), at(a, t + 1)});
            mesh.triangles.push_back({at(a + 1, t + 1), at(a, t + 1), at(a + 1, t)});
        }
    }
    return mesh;
}

inline std::shared_ptr<const Surface> surfaceOf(TriangleMesh mesh)
{
    NoProgress progress;
    return *Surface::build(std::move(mesh), progress);
}

/// Soft and hard content over the stored tiles (see `solidTexture`).
/// \param coarser  times that the content's details are larger than texels
inline TexelStore
solidStore(const TriangleMesh& mesh, const FaceMap<Level>& levels, std::uint64_t coarser)
{
    NoProgress progress;
    const TestData data = *parseTestData(storedTestFiles());
    LevelPlan plan;
    plan.levels = levels;
    for (const Level level : levels.values()) {
        plan.texels += level.texelCount();
    }
    plan.texels /= coarser * coarser;
    return *solidTexture(mesh, plan, data, Threads::all(), progress);
}

inline FaceMap<Level> mixedLevels(std::size_t faces, int least, int most, unsigned seed)
{
    std::mt19937 random(seed);
    FaceMap<Level> levels(faces);
    for (Level& level : levels.values()) {
        level = Level(least + static_cast<int>(random() % static_cast<unsigned>(most - least + 1)));
    }
    return levels;
}

/// Levels that change by one from region to region, as those of a painted mesh do.
inline FaceMap<Level> bandedLevels(const TriangleMesh& mesh, int least, int most)
{
    FaceMap<Level> levels(mesh.faceCount());
    for (std::size_t f = 0; f < levels.size(); ++f) {
        const auto corners = mesh.corners(faceId(f));
        const float x = 0.5F + 0.5F * std::sin(4 * (corners[0].x + corners[1].y));
        levels[faceId(f)] =
            Level(least + static_cast<int>(std::lround(x * static_cast<float>(most - least))));
    }
    return levels;
}

/// Of each texel another colour: what shows every jump.
inline TexelStore noiseStore(const FaceMap<Level>& levels, unsigned seed)
{
    std::mt19937 random(seed);
    TexelStore store(TexelFormat{}, levels, std::vector<std::byte>(3));
    for (std::size_t f = 0; f < levels.size(); ++f) {
        for (std::byte& byte : store.writable(faceId(f))) {
            byte = static_cast<std::byte>(random());
        }
    }
    return store;
}

/// A renderer with all of it on the card, lit by nothing.
inline std::unique_ptr<Renderer> rendererOf(const Surface& surface, const TexelStore& store)
{
    auto renderer = std::move(*Renderer::create());
    (void)renderer->setMesh(surface.mesh());
    renderer->setCorners(SharedCorners::of(surface.mesh(), cornerNormals(surface.mesh())));
    renderer->setTexels(store, 0);
    renderer->setFilterMesh(
        std::make_shared<const FilterMesh>(surface.mesh(), surface.adjacency(), store));
    return renderer;
}

} // namespace trixel::render
