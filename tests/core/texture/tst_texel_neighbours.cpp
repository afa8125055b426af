// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/texture/texel_neighbours.h"
#include "tests/core/test_meshes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <random>

using namespace trixel;

namespace {

/// A sphere whose faces have levels 0 to 4 and are numbered from any corner.
struct Mixed
{
    TriangleMesh mesh = test::sphereMesh(1);
    Adjacency adjacency;
    TexelStore texels;

    Mixed()
    {
        std::mt19937 random(5);
        for (Triangle& face : mesh.triangles) {
            std::rotate(face.begin(), face.begin() + static_cast<long>(random() % 3), face.end());
        }
        adjacency = buildAdjacency(mesh.triangles);
        FaceMap<Level> levels(mesh.faceCount());
        for (std::size_t f = 0; f < levels.size(); ++f) {
            levels[faceId(f)] = Level(static_cast<int>(random() % 5));
        }
        texels =
            TexelStore({TexelType::UInt8, 1, std::nullopt}, levels, std::array<std::byte, 1>{});
    }
    WalkedSurface surface() const { return {adjacency, texels, 0}; }

    glm::vec3 point(FaceId face, glm::dvec2 uv) const
    {
        const auto p = mesh.corners(face);
        const glm::vec2 f(uv);
        return p[0] + f.x * (p[1] - p[0]) + f.y * (p[2] - p[0]);
    }
    /// Start (0) or end (1) of an edge of a texel.
    glm::vec3 end(const TexelPlace& place, LocalEdge edge, int which) const
    {
        const auto uv = corners(surface().level(place.face), place.texel);
        return point(place.face, uv[(indexOf(edge) + static_cast<std::size_t>(which)) % 3]);
    }
};

} // namespace

TEST(TexelNeighbours, lieAlongTheEdgeFromItsStartToItsEnd)
{
    const Mixed sphere;
    const WalkedSurface surface = sphere.surface();
    int several = 0;
    int coarser = 0;
    for (std::size_t f = 0; f < sphere.mesh.faceCount(); ++f) {
        const Level level = surface.level(faceId(f));
        for (std::uint32_t k = 0; k < level.texelCount(); ++k) {
            const TexelPlace place{faceId(f), texelAt(level, static_cast<TexelIndex>(k))};
            for (const LocalEdge edge : kLocalEdges) {
                const auto across = texelsAcross(surface, place, edge);
                ASSERT_TRUE(across); // a sphere has no border
                ASSERT_TRUE(isValid(across->level, across->first));
                ASSERT_TRUE(isValid(across->level, across->last));
                if (across->face != place.face && across->level < level) {
                    // The edge is part of theirs, which runs the other way.
                    const TexelPlace theirs{across->face, across->first};
                    EXPECT_EQ(across->first, across->last);
                    const glm::vec3 from = sphere.end(theirs, across->edge, 0);
                    const glm::vec3 way = sphere.end(theirs, across->edge, 1) - from;
                    for (const int which : {0, 1}) {
                        const glm::vec3 on = sphere.end(place, edge, which) - from;
                        const float part = glm::dot(on, way) / glm::dot(way, way);
                        EXPECT_GT(part, -1e-4F);
                        EXPECT_LT(part, 1.0001F);
                        EXPECT_LT(glm::length(on - part * way), 1e-5F);
                    }
                    ++coarser;
                    continue;
                }
                // They begin and end where the edge does.
                const glm::vec3 start = sphere.end({across->face, across->first}, across->edge, 1);
                const glm::vec3 end = sphere.end({across->face, across->last}, across->edge, 0);
                EXPECT_LT(glm::length(start - sphere.end(place, edge, 0)), 1e-5F);
                EXPECT_LT(glm::length(end - sphere.end(place, edge, 1)), 1e-5F);
                several += across->count > 1 ? 1 : 0;
            }
        }
    }
    EXPECT_GT(several, 100);
    EXPECT_GT(coarser, 100);
}

TEST(TexelNeighbours, theMiddleOfSeveralHalvesTheEdge)
{
    const Mixed sphere;
    const WalkedSurface surface = sphere.surface();
    int met = 0;
    for (std::size_t f = 0; f < sphere.mesh.faceCount(); ++f) {
        const TexelPlace corner{faceId(f), {}};
        for (const LocalEdge edge : {LocalEdge::E0, LocalEdge::E2}) {
            const auto across = texelsAcross(surface, corner, edge);
            if (across->face == corner.face || across->count < 2) {
                continue;
            }
            const glm::vec3 half =
                (sphere.end(corner, edge, 0) + sphere.end(corner, edge, 1)) / 2.0F;
            EXPECT_LT(glm::length(sphere.end(across->middle(), across->edge, 0) - half), 1e-5F);
            ++met;
        }
    }
    EXPECT_GT(met, 10);
}

TEST(TexelNeighbours, aBorderHasNone)
{
    const TriangleMesh fan = test::fanMesh(5);
    const Adjacency adjacency = buildAdjacency(fan.triangles);
    const TexelStore texels(
        5, {TexelType::UInt8, 1, std::nullopt}, Level(1), std::array<std::byte, 1>{});
    const WalkedSurface surface{adjacency, texels, 0};
    EXPECT_FALSE(texelsAcross(surface, {faceId(2), {1, 0, TexelHalf::Lower}}, LocalEdge::E1));
    EXPECT_TRUE(texelsAcross(surface, {faceId(2), {0, 0, TexelHalf::Lower}}, LocalEdge::E1));
}
