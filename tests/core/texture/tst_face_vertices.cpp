// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/texture/face_vertices.h"
#include "core/texture/touched_vertices.h"
#include "tests/core/filter/random_scene.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstring>
#include <utility>

using namespace trixel;
using namespace trixel::test;

namespace {

constexpr std::size_t kRoom = 1U << 24U;

struct Mesh
{
    explicit Mesh(const TriangleMesh& mesh)
        : adjacency(buildAdjacency(mesh.triangles))
        , rings(adjacency)
    {
    }
    Adjacency adjacency;
    VertexRings rings;
};

/// Stored bytes of a face's whole block, made with nothing kept from before.
std::vector<std::byte>
blockOf(const Mesh& mesh, const TexelStore& store, FaceId face, Level most, int drop = 0)
{
    ChainCache chains({0, 1, 2, -1}, kRoom);
    const FaceMips mips(store, chains, drop);
    std::vector<std::byte> bytes;
    FaceVertices(mips, mesh.adjacency, mesh.rings).appendBlock(face, most, bytes);
    return bytes;
}

/// The same as the card reads them.
std::vector<float> valuesOf(const Mesh& mesh, const TexelStore& store, FaceId face)
{
    const std::vector<std::byte> bytes = blockOf(mesh, store, face, store.face(face).level());
    std::vector<float> values(bytes.size() / byteSize(store.format().type));
    decode(store.format().type, bytes, values);
    return values;
}

/// The same texels as another type.
TexelStore converted(const TexelStore& store, TexelType type)
{
    TexelFormat format = store.format();
    format.type = type;
    NoProgress progress;
    return *store.transformed(
        format,
        [&](const FaceTexels& face) {
            std::vector<float> values(face.bytes().size() / sizeof(float));
            decode(TexelType::Float, face.bytes(), values);
            std::vector<std::byte> bytes(values.size() * byteSize(type));
            encode(type, values, bytes);
            return face.isConstant() ? FaceTexels::constant(face.level(), bytes)
                                     : FaceTexels::full(face.level(), format.texelBytes(), bytes);
        },
        Threads{1},
        progress);
}

/// Sets a random rectangle of a face to noise.
TouchedRect paint(Random& random, TexelStore& store, FaceId face, std::uint32_t widest)
{
    const bool wasConstant = store.face(face).isConstant();
    const std::uint32_t r = store.face(face).level().resolution();
    const auto place = [&] { return static_cast<std::uint32_t>(unit(random) * r); };
    TouchedRect rect{face};
    rect.x = static_cast<std::uint16_t>(place());
    rect.y = static_cast<std::uint16_t>(place());
    rect.width = static_cast<std::uint16_t>(std::min(1 + place() % widest, r - rect.x));
    rect.height = static_cast<std::uint16_t>(std::min(1 + place() % widest, r - rect.y));
    rect.wholeFace = wasConstant;
    const std::size_t bytes = store.format().texelBytes();
    const std::span<std::byte> texels = store.writable(face);
    for (std::uint32_t y = rect.y; y < std::uint32_t{rect.y} + rect.height; ++y) {
        for (std::uint32_t x = rect.x; x < std::uint32_t{rect.x} + rect.width; ++x) {
            std::vector<float> values(store.format().channels);
            std::ranges::generate(values, [&] { return static_cast<float>(unit(random)); });
            encode(store.format().type, values, texels.subspan((x + y * r) * bytes, bytes));
        }
    }
    return rect;
}

/// The value that a face shows along an edge when it interpolates its vertices of a level.
double alongEdge(
    const std::vector<float>& block, LocalEdge edge, Level level, double t, std::size_t channel)
{
    const double place = t * level.resolution();
    const auto k = std::min(static_cast<std::uint32_t>(place), level.resolution() - 1);
    const auto at = [&](std::uint32_t n) {
        const LatticePoint p = onEdge(level, edge, n);
        return double{
            block[kGroupChannels * (vertexBlockBegin(level) + latticeVertex(level, p.i, p.j)) +
                  channel]};
    };
    return at(k) + (place - k) * (at(k + 1) - at(k));
}

double largestJump(const Mesh& mesh, const TexelStore& store)
{
    double largest = 0;
    for (std::size_t f = 0; f < store.faceCount(); ++f) {
        const std::vector<float> own = valuesOf(mesh, store, faceId(f));
        for (const LocalEdge edge : kLocalEdges) {
            const auto across = mesh.adjacency.neighbour(faceId(f), edge);
            if (!across || indexOf(across->face) < f) {
                continue;
            }
            const std::vector<float> other = valuesOf(mesh, store, across->face);
            for (int n = 0; n <= 6; ++n) {
                const Level here = std::min(Level(n), store.face(faceId(f)).level());
                const Level there = std::min(Level(n), store.face(across->face).level());
                for (int k = 0; k <= 64; ++k) {
                    const double a = alongEdge(own, edge, here, k / 64.0, 0);
                    const double b = alongEdge(other, across->edge, there, 1 - k / 64.0, 0);
                    largest = std::max(largest, std::abs(a - b));
                }
            }
        }
    }
    return largest;
}

} // namespace

TEST(FaceVertices, areThoseOfTheConformingPyramidToTheBit)
{
    for (std::uint32_t seed = 0; seed < 8; ++seed) {
        Random random(seed);
        const bool closed = seed % 4 != 3; // else with borders
        const TriangleMesh mesh = closed ? randomClosedMesh(random, 1) : flatLattice(3);
        const Mesh about(mesh);
        TexelStore store = noiseStore(random, randomLevels(random, mesh.faceCount(), 0, 6), 3);
        if (seed % 2 == 1) { // some of one value, alone or among their like
            for (std::size_t f = 0; f < mesh.faceCount(); f += 1 + f % 3) {
                const std::vector<float> value{0.25F, 0.5F, 0.75F};
                store.exchange(faceId(f),
                               FaceTexels::constant(store.face(faceId(f)).level(),
                                                    std::as_bytes(std::span(value))));
            }
        }
        NoProgress progress;
        const FloatMips mips = *FloatMips::build(store, Threads{1}, progress);
        const ConformingPyramid pyramid =
            *ConformingPyramid::build(mips, about.adjacency, about.rings, Threads{1}, progress);
        ChainCache chains({0, 1, 2, -1}, 0); // room for nothing
        const FaceMips own(store, chains);
        const FaceVertices vertices(own, about.adjacency, about.rings);
        for (std::size_t f = 0; f < mesh.faceCount(); ++f) {
            const Level level = vertices.level(faceId(f));
            const std::vector<float> values =
                vertices.values({faceId(f), 0, vertexBlockSize(level)});
            chains.trim();
            ASSERT_EQ(chains.bytes(), 0U);
            for (int n = 0; n <= level.log2(); ++n) {
                const LevelVertices expected = pyramid.vertices(faceId(f), Level(n));
                const std::size_t begin = kGroupChannels * vertexBlockBegin(Level(n));
                for (std::size_t k = 0; k < latticeVertexCount(Level(n)); ++k) {
                    for (std::size_t c = 0; c < 3; ++c) {
                        ASSERT_EQ(values[begin + kGroupChannels * k + c],
                                  expected.values[k * expected.stride + c])
                            << "seed " << seed << " face " << f << " level " << n;
                    }
                    ASSERT_EQ(values[begin + kGroupChannels * k + 3], 1.0F);
                }
            }
            EXPECT_EQ(vertices.isConstant(faceId(f)),
                      pyramid.vertices(faceId(f), Level(0)).stride == 0);
        }
    }
}

TEST(FaceVertices, ofACoarserBlockAreTheBeginningOfAFinerOne)
{
    Random random(3);
    const TriangleMesh mesh = randomClosedMesh(random, 0);
    const Mesh about(mesh);
    const TexelStore store = converted(
        noiseStore(random, randomLevels(random, mesh.faceCount(), 2, 5), 3), TexelType::UInt8);
    for (std::size_t f = 0; f < mesh.faceCount(); ++f) {
        const Level level = store.face(faceId(f)).level();
        const std::vector<std::byte> all = blockOf(about, store, faceId(f), level);
        EXPECT_EQ(all.size(), 4 * vertexBlockSize(level));
        const std::vector<std::byte> some = blockOf(about, store, faceId(f), Level(1));
        EXPECT_TRUE(std::equal(some.begin(), some.end(), all.begin()));
    }
}

TEST(FaceVertices, jumpByHalfAStepOfTheirTypeAtMost)
{
    Random random(5);
    const TriangleMesh mesh = randomClosedMesh(random, 1);
    const Mesh about(mesh);
    const TexelStore store = noiseStore(random, randomLevels(random, mesh.faceCount(), 0, 5), 3);
    EXPECT_LE(largestJump(about, store), 1e-7);
    EXPECT_LE(largestJump(about, converted(store, TexelType::UInt8)), 0.5001 / 255);
    EXPECT_LE(largestJump(about, converted(store, TexelType::UInt16)), 0.51 / 65535);
    EXPECT_LE(largestJump(about, converted(store, TexelType::Half)), std::ldexp(1.0, -12));
    // Where neighbours have one level there is nothing to derive, and nothing to jump.
    const TexelStore even = converted(
        noiseStore(random, FaceMap<Level>(mesh.faceCount(), Level(4)), 3), TexelType::UInt8);
    EXPECT_LE(largestJump(about, even), 1e-7);
}

TEST(FaceVertices, shownCoarserAreThoseOfACoarserStore)
{
    Random random(6);
    const TriangleMesh mesh = randomClosedMesh(random, 0);
    const Mesh about(mesh);
    // Level-2 faces whose texels are alike in fours have those as texels one level coarser.
    FaceMap<Level> levels = randomLevels(random, mesh.faceCount(), 1, 4);
    const TexelStore coarse = noiseStore(random, levels, 3);
    for (Level& level : levels.values()) {
        level = Level(level.log2() + 1);
    }
    const TexelStore fine = storeOf(levels, 3, [&](FaceId face, glm::dvec2 uv, int c) {
        const FaceTexels& texels = coarse.face(face);
        const TexelCoord at = texelAt(texels.level(), uv);
        float value = 0;
        std::memcpy(&value,
                    texels.texel(indexOf(texelIndex(texels.level(), at))).data() +
                        static_cast<std::size_t>(c) * sizeof value,
                    sizeof value);
        return value;
    });
    for (std::size_t f = 0; f < mesh.faceCount(); ++f) {
        const Level level = coarse.face(faceId(f)).level();
        EXPECT_EQ(blockOf(about, fine, faceId(f), level, 1),
                  blockOf(about, coarse, faceId(f), level));
    }
}

TEST(TouchedVertices, areAllThatChangeAndFew)
{
    for (std::uint32_t seed = 0; seed < 6; ++seed) {
        Random random(seed);
        const TriangleMesh mesh = seed % 3 != 0 ? randomClosedMesh(random, 1) : flatLattice(3);
        const Mesh about(mesh);
        const int drop = seed == 4 ? 1 : 0;
        TexelStore store = converted(
            noiseStore(random, randomLevels(random, mesh.faceCount(), 1, 6), 3), TexelType::UInt8);
        const auto levelOf = [&](FaceId face) { return store.face(face).level().coarser(drop); };
        ChainCache chains({0, 1, 2, -1}, kRoom);
        std::vector<std::vector<std::byte>> shown;
        for (std::size_t f = 0; f < mesh.faceCount(); ++f) {
            shown.push_back(blockOf(about, store, faceId(f), levelOf(faceId(f)), drop));
        }
        for (int stroke = 0; stroke < 6; ++stroke) {
            TouchedVertices touched(about.adjacency, about.rings, levelOf);
            std::vector<TouchedRect> rects;
            for (int k = 0; k < 3; ++k) {
                const auto face = faceId(std::size_t(unit(random) * double(mesh.faceCount())));
                rects.push_back(paint(random, store, face, 9));
                touched.touch(store.face(face).level(), rects.back());
            }
            chains.update(store, rects);
            const FaceMips mips(store, chains, drop);
            const FaceVertices vertices(mips, about.adjacency, about.rings);
            for (const VertexRun& run : touched.take(8)) {
                std::vector<std::byte> bytes;
                vertices.appendRun(run, bytes);
                std::ranges::copy(bytes, shown[indexOf(run.face)].begin() + 4 * run.first);
            }
            for (std::size_t f = 0; f < mesh.faceCount(); ++f) {
                ASSERT_EQ(shown[f], blockOf(about, store, faceId(f), levelOf(faceId(f)), drop))
                    << "seed " << seed << " stroke " << stroke << " face " << f;
            }
        }
    }
}

TEST(TouchedVertices, growWithTheDabAndNotWithTheFace)
{
    const TriangleMesh mesh = flatLattice(3);
    const Mesh about(mesh);
    for (const int level : {6, 8, 10}) {
        TouchedVertices touched(
            about.adjacency, about.rings, [level](FaceId) { return Level(level); });
        TouchedRect rect{faceId(8), 20, 10, 12, 12};
        touched.touch(Level(level), rect);
        std::size_t count = 0;
        for (const VertexRun& run : touched.take(0)) {
            count += run.count;
        }
        // 13² about the rectangle, then a quarter a level with a rim, down to the corners' few.
        EXPECT_LE(count, 169U + 4 * 64 + 40U * static_cast<unsigned>(level));
    }
}

TEST(VertexBlock, knowsTheRowOfEveryVertex)
{
    for (const int n : {0, 1, 2, 5, 12}) {
        const Level level(n);
        const std::uint32_t r = level.resolution();
        for (std::uint32_t j = 0; j <= r; ++j) {
            const auto begin = static_cast<std::uint32_t>(latticeVertex(level, 0, j));
            ASSERT_EQ(latticeRow(level, begin), j);
            ASSERT_EQ(latticeRow(level, begin + r - j), j);
        }
        EXPECT_EQ(vertexBlockLevel(vertexBlockBegin(level)), level);
        EXPECT_EQ(vertexBlockLevel(vertexBlockSize(level) - 1), level);
    }
}

/// The table of tests/bench/README.md: values in every level together, beside the base's texels.
TEST(VertexBlock, takesAtMostThreeQuartersOfTheTexelsFromLevel6On)
{
    const std::array<std::pair<int, double>, 6> table{
        {{3, 1.078}, {4, 0.867}, {5, 0.765}, {6, 0.715}, {7, 0.690}, {8, 0.678}}};
    for (const auto& [number, stated] : table) {
        const Level level(number);
        std::size_t values = 0;
        for (int n = 0; n <= number; ++n) {
            values += latticeVertexCount(Level(n));
        }
        EXPECT_EQ(vertexBlockSize(level), values);
        const double perTexel = static_cast<double>(values) / level.texelCount();
        EXPECT_NEAR(perTexel, stated, 6e-4) << "level " << number;
        EXPECT_TRUE(number < 6 || perTexel <= 0.75);
    }
}
