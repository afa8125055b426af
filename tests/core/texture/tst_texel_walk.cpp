// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/texture/texel_walk.h"
#include "tests/core/test_meshes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <functional>
#include <optional>
#include <random>
#include <vector>

using namespace trixel;

namespace {

/// Triangles whose vertices are numbered from any of their corners: every pairing of edges occurs.
TriangleMesh turned(TriangleMesh mesh, std::mt19937& random)
{
    for (Triangle& triangle : mesh.triangles) {
        std::rotate(
            triangle.begin(), triangle.begin() + static_cast<long>(random() % 3), triangle.end());
    }
    return mesh;
}

struct Walked
{
    TriangleMesh mesh;
    Adjacency adjacency;
    TexelStore texels;

    Walked(TriangleMesh shape, const std::function<int(std::size_t)>& levelOf)
        : mesh(std::move(shape))
        , adjacency(buildAdjacency(mesh.triangles))
    {
        FaceMap<Level> levels(mesh.triangles.size());
        for (std::size_t f = 0; f < levels.size(); ++f) {
            levels[faceId(f)] = Level(levelOf(f));
        }
        const std::array<std::byte, 1> black{};
        texels = TexelStore({TexelType::UInt8, 1, std::nullopt}, levels, black);
    }

    WalkedSurface surface(int dropped = 0) const { return {adjacency, texels, dropped}; }

    /// In the plane of a flat mesh.
    glm::vec3 point(const TexelPlace& place, glm::dvec2 uv) const
    {
        const auto p = mesh.corners(place.face);
        const glm::vec2 f(uv);
        return p[0] + f.x * (p[1] - p[0]) + f.y * (p[2] - p[0]);
    }
};

/// The number of the corner of a texel that lies at the centre of a fan; nothing: none does.
std::optional<std::uint32_t> cornerAtCentre(const Walked& fan, const TexelPlace& place)
{
    const auto points = corners(fan.surface().level(place.face), place.texel);
    for (std::uint32_t c = 0; c < 3; ++c) {
        if (glm::length(fan.point(place, points[c])) < 1e-6F) {
            return c;
        }
    }
    return std::nullopt;
}

TexelPlace atCentre(const Walked& fan)
{
    const Level level = fan.surface().level(faceId(0));
    TexelPlace place{faceId(0), {}};
    for (std::uint32_t k = 0; !cornerAtCentre(fan, place); ++k) {
        place.texel = texelAt(level, static_cast<TexelIndex>(k));
    }
    return place;
}

/// A strip of equal faces: a long parallelogram cut by its short diagonals, each face one texel.
Walked strip(std::uint32_t faces)
{
    TriangleMesh mesh;
    for (std::uint32_t k = 0; k < faces + 2; ++k) {
        const auto x = static_cast<float>(k);
        mesh.positions.emplace_back(x / 2, k % 2 == 0 ? 0.0F : 1.0F, 0.0F);
    }
    for (std::uint32_t k = 0; k < faces; ++k) {
        mesh.triangles.push_back(k % 2 == 0 ? Triangle{k, k + 2, k + 1}
                                            : Triangle{k, k + 1, k + 2});
    }
    return {std::move(mesh), [](std::size_t) { return 0; }};
}

} // namespace

TEST(TexelWalk, turningRoundAVertexOfAnyValenceReturnsToTheStart)
{
    std::mt19937 random(7);
    for (const std::uint32_t valence : {3U, 5U, 6U, 9U}) {
        for (int trial = 0; trial < 20; ++trial) {
            const Walked fan(turned(test::fanMesh(valence), random),
                             [&](std::size_t) { return static_cast<int>(random() % 5); });
            const TexelPlace start = atCentre(fan);
            const auto corner = static_cast<std::size_t>(*cornerAtCentre(fan, start));
            // The centre at the right hand, then at the left.
            TexelWalk right(start, kLocalEdges[(corner + 2) % 3]);
            TexelWalk left(start, kLocalEdges[corner]);
            for (std::uint32_t k = 1; k <= valence; ++k) {
                ASSERT_TRUE(right.right(fan.surface()));
                ASSERT_TRUE(left.left(fan.surface()));
                EXPECT_TRUE(cornerAtCentre(fan, right.place())) << valence << " step " << k;
                EXPECT_TRUE(cornerAtCentre(fan, left.place())) << valence << " step " << k;
                EXPECT_EQ(right.place() == start, k == valence);
                EXPECT_EQ(left.place() == start, k == valence);
            }
        }
    }
}

TEST(TexelWalk, turningInsideAFaceGoesRoundSixTexels)
{
    const Walked fan(test::fanMesh(3), [](std::size_t) { return 4; });
    const TexelPlace start{faceId(1), {5, 5, TexelHalf::Upper}};
    TexelWalk walk(start);
    for (int k = 1; k <= 6; ++k) {
        ASSERT_TRUE(walk.right(fan.surface()));
        EXPECT_EQ(walk.place() == start, k == 6);
    }
}

TEST(TexelWalk, rightIsToTheRightOfTheWay)
{
    const Walked fan(test::fanMesh(6), [](std::size_t) { return 3; });
    std::mt19937 random(3);
    TexelWalk walk(atCentre(fan));
    const auto middle = [&](const TexelPlace& place) {
        return fan.point(place, centroid(fan.surface().level(place.face), place.texel));
    };
    int turns = 0;
    for (int k = 0; k < 400; ++k) {
        const glm::vec3 here = middle(walk.place());
        const auto edge = corners(fan.surface().level(walk.place().face), walk.place().texel);
        const glm::vec3 way =
            here - 0.5F * (fan.point(walk.place(), edge[indexOf(walk.entered())]) +
                           fan.point(walk.place(), edge[indexOf(nextEdge(walk.entered()))]));
        const bool right = random() % 2 == 0;
        if (right ? walk.right(fan.surface()) : walk.left(fan.surface())) {
            const glm::vec3 step = middle(walk.place()) - here;
            EXPECT_EQ(way.x * step.y - way.y * step.x < 0, right);
            ++turns;
        }
    }
    EXPECT_GT(turns, 300);
}

TEST(TexelWalk, aheadGoesStraightThroughAStrip)
{
    const Walked faces = strip(12);
    // Into the first face by the short side, a left turn to begin with.
    TexelWalk walk({faceId(0), {}}, LocalEdge::E2);
    ASSERT_TRUE(walk.left(faces.surface()));
    for (std::size_t k = 2; k < 12; ++k) {
        ASSERT_TRUE(walk.ahead(faces.surface()));
        EXPECT_EQ(walk.place().face, faceId(k));
    }
    EXPECT_FALSE(walk.ahead(faces.surface()));
    EXPECT_EQ(walk.place().face, faceId(11));
}

TEST(TexelWalk, backRetracesAnyWay)
{
    std::mt19937 random(11);
    const Walked sphere(turned(test::sphereMesh(1), random),
                        [&](std::size_t) { return static_cast<int>(random() % 6); });
    const WalkedSurface surface = sphere.surface(1);
    TexelWalk walk({faceId(3), {}});
    std::vector<TexelPlace> places;
    for (int k = 0; k < 500; ++k) {
        places.push_back(walk.place());
        const auto choice = random() % 3;
        ASSERT_TRUE(choice == 0   ? walk.right(surface)
                    : choice == 1 ? walk.left(surface)
                                  : walk.ahead(surface));
        ASSERT_TRUE(isValid(surface.level(walk.place().face), walk.place().texel));
    }
    for (; !places.empty(); places.pop_back()) {
        ASSERT_TRUE(walk.back(surface));
        EXPECT_EQ(walk.place(), places.back());
    }
}

TEST(TexelWalk, aheadEntersTheMiddleOfFinerTexels)
{
    const Walked fan(test::fanMesh(6), [](std::size_t f) { return f == 1 ? 4 : 0; });
    // Face 0's edge 2 and face 1's edge 0 run from and to the centre.
    TexelWalk walk({faceId(0), {}}, LocalEdge::E1);
    ASSERT_TRUE(walk.ahead(fan.surface())); // turns right: by edge 2
    EXPECT_EQ(walk.place(), (TexelPlace{faceId(1), {8, 0, TexelHalf::Lower}}));
}

TEST(TexelWalk, aBorderStopsTheWalkWhereItStands)
{
    const Walked fan(test::fanMesh(5), [](std::size_t) { return 1; });
    const TexelPlace start{faceId(2), {1, 0, TexelHalf::Lower}};
    TexelWalk walk(start);
    EXPECT_FALSE(walk.right(fan.surface()));
    EXPECT_EQ(walk.place(), start);
    EXPECT_EQ(walk.entered(), LocalEdge::E0);
}
