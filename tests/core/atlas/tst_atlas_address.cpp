// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/atlas/atlas_address.h"
#include "core/lattice/edge_transfer.h"
#include "core/texture/mips.h"
#include "tests/core/atlas/atlas_pages.h"

#include <gtest/gtest.h>

#include <set>

using namespace trixel;
using namespace trixel::test;

namespace {

constexpr int kGrid = 7;

FaceMap<Level> randomLevels(std::size_t faces, int most, unsigned seed)
{
    std::mt19937 random(seed);
    FaceMap<Level> levels(faces);
    for (std::size_t f = 0; f < faces; ++f) {
        levels[faceId(f)] = Level(static_cast<int>(random() % static_cast<unsigned>(most + 1)));
    }
    return levels;
}

TexelStore noise(const FaceMap<Level>& levels, unsigned seed)
{
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> in(0, 1);
    return storeOf(levels, [&](FaceId, glm::dvec2) { return in(random); });
}

AtlasPages pagesOf(const TexelStore& store,
                   const FaceMap<Level>& levels,
                   const Adjacency& adjacency,
                   const AtlasOptions& options)
{
    return {AtlasLayout::plan(levels, options).value(), store, adjacency};
}

/// In the face, edges and corners among them.
glm::dvec2 placeIn(std::mt19937& random)
{
    std::uniform_real_distribution<double> in(0, 1);
    glm::dvec2 uv(in(random), in(random));
    if (uv.x + uv.y > 1) {
        uv = 1.0 - uv;
    }
    switch (random() % 6) {
    case 0:
        return {uv.x, 0};
    case 1:
        return {0, uv.y};
    case 2:
        return {uv.x, 1 - uv.x};
    case 3:
        return {random() % 2, 0};
    default:
        return uv;
    }
}

TEST(AtlasAddress, nearestFindsEveryTexelOfEveryLevelToTheBit)
{
    const TriangleMesh mesh = turnedGrid(kGrid, 1);
    const Adjacency adjacency = buildAdjacency(mesh.triangles);
    const FaceMap<Level> levels = randomLevels(mesh.faceCount(), 7, 2);
    const TexelStore store = noise(levels, 3);
    for (const AtlasBorder border : {AtlasBorder::None, AtlasBorder::Bilinear}) {
        for (const AtlasPacking packing : {AtlasPacking::Bands, AtlasPacking::Shelves}) {
            AtlasOptions options{border, packing, true, 300};
            const AtlasPages atlas = pagesOf(store, levels, adjacency, options);
            EXPECT_GT(atlas.layout.pages().size(), 1U);
            for (std::size_t f = 0; f < levels.size(); ++f) {
                FaceTexels texels = store.face(faceId(f));
                while (true) {
                    for (std::uint32_t k = 0; k < texels.level().texelCount(); ++k) {
                        const glm::dvec2 uv =
                            centroid(texels.level(), texelAt(texels.level(), TexelIndex(k)));
                        const float found =
                            atlas.value(nearestTap(atlas.layout, faceId(f), texels.level(), uv));
                        ASSERT_EQ(std::memcmp(&found, texels.texel(k).data(), 4), 0);
                    }
                    if (texels.level() == Level()) {
                        break;
                    }
                    texels = reduced(kOneFloat, texels);
                }
            }
        }
    }
}

/// Vertices of a face and, a ring further, of the faces about it.
std::set<std::uint32_t> verticesAbout(const TriangleMesh& mesh, std::size_t face, int rings)
{
    std::set<std::uint32_t> vertices(mesh.triangles[face].begin(), mesh.triangles[face].end());
    for (int k = 1; k < rings; ++k) {
        std::set<std::uint32_t> more = vertices;
        for (const Triangle& other : mesh.triangles) {
            if (std::ranges::any_of(other, [&](auto v) { return vertices.contains(v); })) {
                more.insert(other.begin(), other.end());
            }
        }
        vertices = std::move(more);
    }
    return vertices;
}

/// A stencil reaches two cells beyond: from level 2 on not farther than the faces that share a
/// vertex, below that one ring more.
TEST(AtlasAddress, interpolatingReadsNothingButTheFaceAndThoseAboutIt)
{
    const TriangleMesh mesh = turnedGrid(kGrid, 4);
    const Adjacency adjacency = buildAdjacency(mesh.triangles);
    const FaceMap<Level> levels = randomLevels(mesh.faceCount(), 5, 5);
    std::mt19937 random(6);
    for (std::size_t f = 0; f < mesh.faceCount(); ++f) {
        for (const int rings : {1, 2}) {
            const auto about = verticesAbout(mesh, f, rings);
            int sentinels = 0;
            const TexelStore store = storeOf(levels, [&](FaceId face, glm::dvec2) {
                const bool meets = std::ranges::any_of(mesh.triangles[indexOf(face)],
                                                       [&](auto v) { return about.contains(v); });
                sentinels += meets ? 0 : 1;
                return meets ? 1.0F : -1e6F;
            });
            ASSERT_GT(sentinels, 0);
            const AtlasPages atlas =
                pagesOf(store,
                        levels,
                        adjacency,
                        {AtlasBorder::Bilinear, AtlasPacking::Shelves, true, 300});
            if (rings == 1 && levels[faceId(f)] < Level(2)) {
                continue;
            }
            for (int k = 0; k < 40; ++k) {
                const double level =
                    (rings == 1 ? 2 : 0) + 4.0 * static_cast<double>(random()) / 4294967295.0;
                const auto taps = trilinearTaps(atlas.layout, faceId(f), level, placeIn(random));
                ASSERT_NEAR(atlas.sum(taps), 1.0, 1e-9);
            }
        }
    }
}

TEST(AtlasAddress, interpolatingKeepsAnAffineFunctionUpToTheEdges)
{
    const TriangleMesh mesh = turnedGrid(kGrid, 7);
    const Adjacency adjacency = buildAdjacency(mesh.triangles);
    const auto affine = [](glm::vec3 p) { return 3 * p.x - 2 * p.y + 7; };
    const FaceMap<Level> levels(mesh.faceCount(), Level(4));
    const TexelStore store = storeOf(
        levels, [&](FaceId face, glm::dvec2 uv) { return affine(pointOf(mesh, face, uv)); });
    const AtlasPages atlas = pagesOf(
        store, levels, adjacency, {AtlasBorder::Bilinear, AtlasPacking::Shelves, false, 4096});
    std::mt19937 random(8);
    int checked = 0;
    for (int k = 0; k < 20'000; ++k) {
        const FaceId face = faceId(random() % mesh.faceCount());
        const glm::dvec2 uv = placeIn(random);
        const glm::vec3 point = pointOf(mesh, face, uv);
        if (std::min({point.x, point.y, kGrid - point.x, kGrid - point.y}) < 0.25F) {
            continue; // stencils that reach beyond the mesh
        }
        ++checked;
        ASSERT_NEAR(atlas.sum(bilinearTaps(atlas.layout, face, Level(4), uv)), affine(point), 1e-4);
    }
    EXPECT_GT(checked, 5'000);
}

/// The seams that are left, and why this is for export: where like edges meet both sides
/// interpolate in the same cells; elsewhere they don't.
TEST(AtlasAddress, likeEdgesAgreeAndOthersJump)
{
    const TriangleMesh mesh = turnedGrid(kGrid, 9);
    const Adjacency adjacency = buildAdjacency(mesh.triangles);
    const FaceMap<Level> levels(mesh.faceCount(), Level(4));
    const AtlasPages atlas = pagesOf(noise(levels, 10),
                                     levels,
                                     adjacency,
                                     {AtlasBorder::Bilinear, AtlasPacking::Shelves, false, 4096});
    double likeMost = 0;
    double otherMost = 0;
    for (std::size_t f = 0; f < mesh.faceCount(); ++f) {
        for (const LocalEdge edge : {LocalEdge::E0, LocalEdge::E1, LocalEdge::E2}) {
            const auto other = adjacency.neighbour(faceId(f), edge);
            // Near its ends an edge's stencils reach round corners, where neighbours fan out.
            for (double t = 0.2; other && t < 0.8; t += 0.013) {
                const glm::dvec2 here = fromEdge(edge, {t, 0});
                const glm::dvec2 there = acrossEdge(edge, other->edge, here);
                const double jump =
                    std::abs(atlas.sum(bilinearTaps(atlas.layout, faceId(f), Level(4), here)) -
                             atlas.sum(bilinearTaps(atlas.layout, other->face, Level(4), there)));
                double& most = edge == other->edge ? likeMost : otherMost;
                most = std::max(most, jump);
            }
        }
    }
    EXPECT_LT(likeMost, 1e-6);
    EXPECT_GT(otherMost, 0.05);
}

TEST(AtlasAddress, theTableSaysWhatTheLayoutSays)
{
    const FaceMap<Level> levels = randomLevels(400, 6, 11);
    for (const bool mips : {false, true}) {
        const AtlasLayout layout =
            AtlasLayout::plan(levels, {AtlasBorder::Bilinear, AtlasPacking::Shelves, mips, 400})
                .value();
        const std::vector<std::uint32_t> table = atlasTable(layout);
        for (std::size_t f = 0; f < levels.size(); ++f) {
            const std::uint32_t record = table[table[3] + f];
            EXPECT_EQ(record % 16, static_cast<std::uint32_t>(levels[faceId(f)].log2()));
            EXPECT_EQ(layout.faceOfRank(record / 16), faceId(f));
        }
        EXPECT_EQ(table.size(), table[3] + levels.size());
    }
}

} // namespace
