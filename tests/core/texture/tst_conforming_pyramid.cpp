// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/lattice/edge_transfer.h"
#include "core/texture/conforming_pyramid.h"
#include "tests/core/filter/random_scene.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

using namespace trixel;
using namespace trixel::test;

namespace {

struct Built
{
    Adjacency adjacency;
    VertexRings rings;
    TexelStore store;
    FloatMips mips;
    ConformingPyramid pyramid;
};

Built built(const TriangleMesh& mesh, TexelStore store, unsigned threads = 1)
{
    NoProgress progress;
    Built all;
    all.adjacency = buildAdjacency(mesh.triangles);
    all.rings = VertexRings(all.adjacency);
    all.store = std::move(store);
    all.mips = *FloatMips::build(all.store, Threads{threads}, progress);
    all.pyramid =
        *ConformingPyramid::build(all.mips, all.adjacency, all.rings, Threads{threads}, progress);
    return all;
}

const float* vertexOf(const ConformingPyramid& pyramid, FaceId face, Level level, LatticePoint at)
{
    const LevelVertices vertices = pyramid.vertices(face, level);
    return vertices.values + vertices.stride * latticeVertex(level, at.i, at.j);
}

/// Mean of every texel of the face that has the lattice point as a corner, found by looking.
struct Around
{
    double sum = 0;
    int count = 0;
};
Around texelsAround(const FloatMips& mips, FaceId face, Level level, LatticePoint at)
{
    Around around;
    const glm::dvec2 point = glm::dvec2(at.i, at.j) / double(level.resolution());
    for (std::uint32_t t = 0; t < level.texelCount(); ++t) {
        const TexelCoord coord = texelAt(level, static_cast<TexelIndex>(t));
        for (const glm::dvec2 corner : corners(level, coord)) {
            if (glm::length(corner - point) < 1e-9) {
                around.sum += mips.texels(face, level).texel(static_cast<TexelIndex>(t))[0];
                ++around.count;
            }
        }
    }
    return around;
}

/// A closed fan of `valence` triangles about a vertex, closed below by another.
TriangleMesh bipyramid(std::uint32_t valence)
{
    TriangleMesh mesh;
    mesh.positions = {{0, 0, 1}, {0, 0, -1}};
    for (std::uint32_t k = 0; k < valence; ++k) {
        const float angle = 6.2831853F * float(k) / float(valence);
        mesh.positions.emplace_back(std::cos(angle), std::sin(angle), 0);
    }
    for (std::uint32_t k = 0; k < valence; ++k) {
        const std::uint32_t a = 2 + k;
        const std::uint32_t b = 2 + (k + 1) % valence;
        mesh.triangles.push_back({a, b, 0});
        mesh.triangles.push_back({1, b, a});
    }
    return mesh;
}

/// The value along an edge at every vertex of a fine lattice, by linear interpolation of a level.
double alongEdge(const ConformingPyramid& pyramid, FaceId face, LocalEdge edge, int level, double t)
{
    const Level at = std::min(Level(level), pyramid.level(face));
    const double place = t * at.resolution();
    const auto k = std::min(static_cast<std::uint32_t>(place), at.resolution() - 1);
    const double from = vertexOf(pyramid, face, at, onEdge(at, edge, k))[0];
    const double to = vertexOf(pyramid, face, at, onEdge(at, edge, k + 1))[0];
    return from + (place - k) * (to - from);
}

double largestJump(const Built& all)
{
    double largest = 0;
    for (std::size_t f = 0; f < all.adjacency.faceCount(); ++f) {
        for (const LocalEdge edge : kLocalEdges) {
            const auto across = all.adjacency.neighbour(faceId(f), edge);
            for (int level = 0; across && level <= 10; ++level) {
                for (int k = 0; k <= 64; ++k) {
                    const double here = alongEdge(all.pyramid, faceId(f), edge, level, k / 64.0);
                    const double there =
                        alongEdge(all.pyramid, across->face, across->edge, level, 1 - k / 64.0);
                    largest = std::max(largest, std::abs(here - there));
                }
            }
        }
    }
    return largest;
}

bool sameValues(const ConformingPyramid& a, const ConformingPyramid& b, int groups)
{
    for (std::size_t f = 0; f < a.faceCount(); ++f) {
        const FaceId face = faceId(f);
        if (a.level(face) != b.level(face)) {
            return false;
        }
        for (int n = 0; n <= a.level(face).log2(); ++n) {
            for (int group = 0; group < groups; ++group) {
                const LevelVertices x = a.vertices(face, Level(n), group);
                const LevelVertices y = b.vertices(face, Level(n), group);
                for (std::size_t k = 0; k < latticeVertexCount(Level(n)); ++k) {
                    if (!std::equal(x.values + k * x.stride,
                                    x.values + k * x.stride + kGroupChannels,
                                    y.values + k * y.stride)) {
                        return false;
                    }
                }
            }
        }
    }
    return true;
}

/// Sets a random rectangle of the packed square to noise; says what was touched.
TouchedRect paint(Random& random, TexelStore& store, FaceId face, std::uint32_t widest)
{
    const Level level = store.face(face).level();
    const std::uint32_t r = level.resolution();
    const bool wasConstant = store.face(face).isConstant();
    const auto below = [&](std::uint32_t n) { return std::uint32_t(unit(random) * n); };
    TouchedRect rect{face};
    rect.x = std::uint16_t(below(r));
    rect.y = std::uint16_t(below(r));
    rect.width = std::uint16_t(1 + below(std::min(widest, r - rect.x)));
    rect.height = std::uint16_t(1 + below(std::min(widest, r - rect.y)));
    rect.wholeFace = wasConstant;
    auto bytes = store.writable(face);
    const std::size_t texel = store.format().texelBytes();
    for (std::size_t y = rect.y; y < rect.y + std::size_t{rect.height}; ++y) {
        for (std::size_t b = 0; b < rect.width * texel; b += sizeof(float)) {
            const auto value = static_cast<float>(unit(random));
            std::memcpy(bytes.data() + (rect.x + y * r) * texel + b, &value, sizeof(float));
        }
    }
    return rect;
}

} // namespace

TEST(ConformingPyramid, isContinuousOnEveryEdgeOfIrregularMeshesWithLevelsTenApart)
{
    for (std::uint32_t seed = 0; seed < 3; ++seed) {
        Random random(seed);
        const TriangleMesh mesh = randomClosedMesh(random, 1);
        FaceMap<Level> levels = randomLevels(random, mesh.faceCount(), 0, 4);
        levels[faceId(seed)] = Level(10); // beside coarse ones
        EXPECT_LE(largestJump(built(mesh, noiseStore(random, levels, 1))), 1e-6);
    }
}

TEST(ConformingPyramid, isContinuousAboutVerticesOfValenceThreeToAHundred)
{
    for (const std::uint32_t valence : {3U, 4U, 5U, 7U, 12U, 100U}) {
        Random random(valence);
        const TriangleMesh mesh = bipyramid(valence);
        const Built all =
            built(mesh, noiseStore(random, randomLevels(random, mesh.faceCount(), 0, 5), 1));
        EXPECT_LE(largestJump(all), 1e-6) << valence;
        // All faces about the apex have one value there, at every level.
        for (int level = 0; level <= 5; ++level) {
            for (std::uint32_t k = 1; k < valence; ++k) {
                const auto at = [&](std::uint32_t n) {
                    const FaceId face = faceId(2 * n);
                    const Level own = std::min(Level(level), all.pyramid.level(face));
                    return vertexOf(all.pyramid, face, own, onEdge(own, LocalEdge::E2, 0))[0];
                };
                const auto coarsest = [&] {
                    int least = level;
                    for (std::uint32_t n = 0; n < valence; ++n) {
                        least = std::min(least, all.pyramid.level(faceId(2 * n)).log2());
                    }
                    return least;
                };
                if (level <= all.pyramid.level(faceId(2 * k)).log2() || coarsest() < level) {
                    EXPECT_FLOAT_EQ(at(k), at(0)) << valence << " level " << level;
                }
            }
        }
    }
}

TEST(ConformingPyramid, followsItsFiveRules)
{
    Random random(5);
    // Two cells of a flat lattice: borders all around, edges inside.
    for (const bool closed : {false, true}) {
        const TriangleMesh mesh = closed ? randomClosedMesh(random, 0, 10) : flatLattice(2);
        const Built all =
            built(mesh, noiseStore(random, randomLevels(random, mesh.faceCount(), 1, 4), 1));
        std::array<int, 5> checkedRules{};
        for (std::size_t f = 0; f < mesh.faceCount(); ++f) {
            const FaceId face = faceId(f);
            const Level own = all.mips.level(face);
            for (int n = 0; n <= own.log2(); ++n) {
                const Level level(n);
                const std::uint32_t r = level.resolution();
                for (std::uint32_t j = 0; j <= r; ++j) {
                    for (std::uint32_t i = 0; i + j <= r; ++i) {
                        Around around;
                        const bool isCorner = (i == 0 && j == 0) || i == r || j == r;
                        const LocalEdge edge = j == 0   ? LocalEdge::E0
                                               : i == 0 ? LocalEdge::E2
                                                        : LocalEdge::E1;
                        const bool onAnEdge = j == 0 || i == 0 || i + j == r;
                        double expected = 0;
                        int rule = 1;
                        const std::uint32_t k = edge == LocalEdge::E0   ? i
                                                : edge == LocalEdge::E1 ? j
                                                                        : r - j;
                        const auto across = all.adjacency.neighbour(face, edge);
                        if (isCorner) {
                            rule = 4;
                            const std::uint8_t corner = i == r ? 1 : j == r ? 2 : 0;
                            const auto ring = all.rings.corners(all.rings.ring({face, corner}));
                            Level from = level;
                            for (const Corner& other : ring) {
                                from = std::min(from, all.mips.level(other.face));
                            }
                            for (const Corner& other : ring) {
                                const Around one = texelsAround(
                                    all.mips,
                                    other.face,
                                    from,
                                    onEdge(from, static_cast<LocalEdge>(other.index), 0));
                                EXPECT_EQ(one.count, 1);
                                around.sum += one.sum;
                                ++around.count;
                            }
                        } else if (!onAnEdge) {
                            around = texelsAround(all.mips, face, level, {i, j});
                            EXPECT_EQ(around.count, 6);
                        } else if (!across) {
                            rule = 5;
                            around = texelsAround(all.mips, face, level, {i, j});
                            EXPECT_EQ(around.count, 3);
                        } else if (all.mips.level(across->face) < level) {
                            rule = 3;
                        } else {
                            rule = 2;
                            around = texelsAround(all.mips, face, level, {i, j});
                            const Around there = texelsAround(
                                all.mips, across->face, level, onEdge(level, across->edge, r - k));
                            around.sum += there.sum;
                            around.count += there.count;
                            EXPECT_EQ(around.count, 6);
                        }
                        if (rule == 3) {
                            expected = alongEdge(all.pyramid,
                                                 across->face,
                                                 across->edge,
                                                 all.mips.level(across->face).log2(),
                                                 1 - double(k) / r);
                        } else {
                            expected = around.sum / around.count;
                        }
                        ++checkedRules[static_cast<std::size_t>(rule - 1)];
                        EXPECT_NEAR(vertexOf(all.pyramid, face, level, {i, j})[0], expected, 2e-7)
                            << "rule " << rule;
                    }
                }
            }
        }
        EXPECT_GT(checkedRules[0], 0);
        EXPECT_GT(checkedRules[1], 0);
        EXPECT_GT(checkedRules[2], 0);
        EXPECT_GT(checkedRules[3], 0);
        EXPECT_EQ(checkedRules[4] > 0, !closed);
    }
}

TEST(ConformingPyramid, keepsAConstantToTheBit)
{
    Random random(6);
    const TriangleMesh mesh = randomClosedMesh(random);
    const Built all = built(mesh,
                            storeOf(randomLevels(random, mesh.faceCount(), 0, 5),
                                    5,
                                    [](FaceId, glm::dvec2, int c) { return 0.1F * float(c + 1); }));
    for (std::size_t f = 0; f < mesh.faceCount(); ++f) {
        for (int n = 0; n <= all.pyramid.level(faceId(f)).log2(); ++n) {
            for (int group = 0; group < 2; ++group) {
                const LevelVertices vertices = all.pyramid.vertices(faceId(f), Level(n), group);
                for (std::size_t k = 0; k < latticeVertexCount(Level(n)); ++k) {
                    const float* value = vertices.values + vertices.stride * k;
                    for (int c = 0; c < (group == 0 ? 4 : 1); ++c) {
                        ASSERT_EQ(value[c], 0.1F * float(4 * group + c + 1));
                    }
                }
            }
        }
    }
}

TEST(ConformingPyramid, keepsAnAffineTextureAwayFromBorders)
{
    const TriangleMesh mesh = flatLattice(6);
    const auto affine = [&](FaceId face, glm::dvec2 uv) {
        const glm::vec3 p = pointAt(mesh.corners(face), float(uv.x), float(uv.y));
        return 0.1F * p.x - 0.07F * p.y + 0.3F;
    };
    const Built all = built(mesh,
                            storeOf(FaceMap<Level>(mesh.faceCount(), Level(4)),
                                    1,
                                    [&](FaceId f, glm::dvec2 uv, int) { return affine(f, uv); }));
    for (const std::size_t f : {2 * (2 + 6 * 2) + 0, 2 * (3 + 6 * 3) + 1}) {
        for (int n = 0; n <= 4; ++n) {
            const std::uint32_t r = Level(n).resolution();
            for (std::uint32_t j = 0; j <= r; ++j) {
                for (std::uint32_t i = 0; i + j <= r; ++i) {
                    EXPECT_NEAR(vertexOf(all.pyramid, faceId(f), Level(n), {i, j})[0],
                                affine(faceId(f), glm::dvec2(i, j) / double(r)),
                                1e-6);
                }
            }
        }
    }
}

TEST(ConformingPyramid, afterAnUpdateEqualsOneBuiltAnew)
{
    for (std::uint32_t seed = 0; seed < 12; ++seed) {
        Random random(seed);
        const bool closed = seed % 3 != 0;
        const TriangleMesh mesh = closed ? randomClosedMesh(random, 1) : flatLattice(3);
        const FaceMap<Level> levels = randomLevels(random, mesh.faceCount(), 0, 6);
        // Half of the seeds begin unpainted, so that faces share their blocks.
        const std::vector<float> fill(6, 0.5F);
        const TexelFormat format{TexelType::Float, 6, std::nullopt};
        TexelStore store = seed % 2 == 0
                               ? noiseStore(random, levels, 6)
                               : TexelStore(format, levels, std::as_bytes(std::span(fill)));
        Built all = built(mesh, store);
        const Built before = all; // shares every block
        const Built same = built(mesh, store);
        for (int stroke = 0; stroke < 4; ++stroke) {
            std::vector<TouchedRect> rects;
            for (int k = 0; k < 5; ++k) {
                const auto face = faceId(std::size_t(unit(random) * double(mesh.faceCount())));
                rects.push_back(paint(random, all.store, face, stroke == 3 ? 64 : 5));
            }
            if (stroke == 2) { // another level
                const auto face = faceId(std::size_t(unit(random) * double(mesh.faceCount())));
                const Level level(1 + int(unit(random) * 5));
                std::vector<float> texels(level.texelCount() * 6);
                std::ranges::generate(texels, [&] { return float(unit(random)); });
                all.store.exchange(
                    face,
                    FaceTexels::full(level, format.texelBytes(), std::as_bytes(std::span(texels))));
                TouchedRect whole{face};
                whole.wholeFace = true;
                std::erase_if(rects, [&](const TouchedRect& r) { return r.face == face; });
                rects.push_back(whole);
            }
            all.mips.update(all.store, rects);
            all.pyramid.update(all.mips, all.adjacency, all.rings, rects);
            const Built anew = built(mesh, all.store);
            ASSERT_TRUE(sameValues(all.pyramid, anew.pyramid, 2)) << seed << " stroke " << stroke;
            for (std::size_t f = 0; f < mesh.faceCount(); ++f) {
                const Level level = all.mips.level(faceId(f));
                for (Level n = level;; n = n.coarser()) {
                    const LevelTexels x = all.mips.texels(faceId(f), n, 1);
                    const LevelTexels y = anew.mips.texels(faceId(f), n, 1);
                    for (std::uint32_t t = 0; t < n.texelCount(); ++t) {
                        const auto index = static_cast<TexelIndex>(t);
                        ASSERT_TRUE(std::equal(x.texel(index), x.texel(index) + 4, y.texel(index)));
                    }
                    if (n == Level(0)) {
                        break;
                    }
                }
            }
        }
        EXPECT_TRUE(sameValues(before.pyramid, same.pyramid, 2)) << "the copy was written to";
    }
}

TEST(ConformingPyramid, updatesWhatWasTouchedAndNoMore)
{
    Random random(9);
    const TriangleMesh mesh = flatLattice(3);
    Built all = built(mesh, noiseStore(random, FaceMap<Level>(mesh.faceCount(), Level(8)), 3));
    const std::size_t whole = all.pyramid.valueCount() / mesh.faceCount();
    for (int k = 0; k < 30; ++k) {
        const TouchedRect rect = paint(random, all.store, faceId(8), 12);
        const std::size_t texels = std::size_t{rect.width} * rect.height;
        const std::size_t reduced = all.mips.update(all.store, {{rect}});
        const std::size_t set = all.pyramid.update(all.mips, all.adjacency, all.rings, {{rect}});
        // About a rectangle of cells there are (w+1)(h+1) vertices; a rectangle across the
        // diagonal of the packed square is two of cells. Then a quarter a level, and some at the
        // rim of each.
        const std::size_t around = std::size_t{rect.width} + rect.height;
        EXPECT_LE(set, 2 * (texels + around) * 4 / 3 + 60 * 8);
        EXPECT_LE(reduced, texels + 4 * (texels + around) / 3 + 8 * 8);
        EXPECT_LT(set, whole / 20);
    }
    // Where a level-0 neighbour makes an edge derived, a touched corner costs that edge.
    FaceMap<Level> levels(2, Level(8));
    levels[faceId(1)] = Level(0);
    Built mixed = built(flatLattice(1), noiseStore(random, levels, 1));
    TouchedRect inside{faceId(0), 100, 60, 1, 1};
    mixed.store.writable(faceId(0));
    const std::size_t set =
        mixed.pyramid.update(mixed.mips, mixed.adjacency, mixed.rings, {{inside}});
    // Every derived vertex of the shared edge, 502 at levels 1 to 8: level 0 reaches its ends.
    EXPECT_GE(set, 502U);
    EXPECT_LE(set, 700U);
}

TEST(ConformingPyramid, costsNextToNothingWhereNothingIsPainted)
{
    constexpr std::uint32_t kFaces = 20000;
    const TriangleMesh mesh = flatLattice(100);
    ASSERT_EQ(mesh.faceCount(), kFaces);
    const std::array<std::byte, 3> grey{std::byte{128}, std::byte{128}, std::byte{128}};
    const Built all = built(mesh, TexelStore(kFaces, TexelFormat{}, Level(7), grey));
    EXPECT_LT(all.pyramid.memoryBytes(), 5 * kFaces);
    EXPECT_LT(all.mips.memoryBytes(), 5 * kFaces);
}

TEST(ConformingPyramid, storesATileOnceHoweverOftenItIsRepeated)
{
    Random random(12);
    const std::uint32_t cells = 24;
    const TriangleMesh mesh = flatLattice(cells);
    // A tile of two by two cells.
    TexelStore tile = noiseStore(random, FaceMap<Level>(8, Level(4)), 1);
    TexelStore store = noiseStore(random, FaceMap<Level>(mesh.faceCount(), Level(0)), 1);
    for (std::uint32_t y = 0; y < cells; ++y) {
        for (std::uint32_t x = 0; x < cells; ++x) {
            for (std::uint32_t half = 0; half < 2; ++half) {
                store.exchange(faceId(2 * (x + y * cells) + half),
                               tile.face(faceId(2 * (x % 2 + y % 2 * 2) + half)));
            }
        }
    }
    const Built all = built(mesh, store);
    const std::size_t block = ConformingPyramid::groupSize(Level(4)) * sizeof(float);
    // 8 inside; on each side of the patch the tile's faces again, and at its corners.
    EXPECT_LT(all.pyramid.memoryBytes(), 45 * block + 5 * mesh.faceCount());
    // Shared or not, the values are the same.
    TexelStore unshared = store;
    for (std::size_t f = 0; f < mesh.faceCount(); ++f) {
        unshared.writable(faceId(f));
    }
    const Built apart = built(mesh, unshared);
    EXPECT_GT(apart.pyramid.memoryBytes(), mesh.faceCount() * block);
    EXPECT_TRUE(sameValues(all.pyramid, apart.pyramid, 1));
}

TEST(ConformingPyramid, isTheSameHoweverManyThreadsBuildIt)
{
    Random random(14);
    const TriangleMesh mesh = randomClosedMesh(random, 0);
    FaceMap<Level> levels = randomLevels(random, mesh.faceCount(), 0, 6);
    levels[faceId(0)] = Level(9);
    const TexelStore store = noiseStore(random, levels, 2);
    EXPECT_TRUE(sameValues(built(mesh, store, 1).pyramid, built(mesh, store, 3).pyramid, 1));
}

TEST(ConformingPyramid, storesFewerValuesThanThreeQuartersOfTheTexels)
{
    for (int n = 6; n <= Level::kMax; ++n) {
        const double values = double(ConformingPyramid::groupSize(Level(n))) / kGroupChannels;
        EXPECT_LE(values / Level(n).texelCount(), 0.75) << n;
    }
}

TEST(ConformingPyramid, stopsWhenItIsCancelled)
{
    class Never final : public Progress
    {
        bool report(double) override { return false; }
    };
    Random random(2);
    const TriangleMesh mesh = flatLattice(2);
    const Built all = built(mesh, noiseStore(random, FaceMap<Level>(8, Level(2)), 1));
    Never never;
    EXPECT_FALSE(ConformingPyramid::build(all.mips, all.adjacency, all.rings, Threads{1}, never));
    EXPECT_FALSE(FloatMips::build(all.store, Threads{1}, never));
}
