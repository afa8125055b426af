// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/atlas/atlas_texels.h"
#include "core/texture/mips.h"
#include "core/texture/stored_faces.h"
#include "tests/core/atlas/atlas_pages.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <random>

using namespace trixel;
using namespace trixel::test;

namespace {

float affine(glm::vec3 point)
{
    return 3 * point.x - 2 * point.y + 7;
}

/// Every texel holds the function's value at its centroid.
TexelStore affineStore(const TriangleMesh& mesh, Level level)
{
    return storeOf(FaceMap<Level>(mesh.faceCount(), level),
                   [&](FaceId face, glm::dvec2 uv) { return affine(pointOf(mesh, face, uv)); });
}

TexelStore randomStore(std::size_t faces, const TexelFormat& format, int most, unsigned seed)
{
    std::mt19937 random(seed);
    FaceMap<Level> levels(faces);
    for (std::size_t f = 0; f < faces; ++f) {
        levels[faceId(f)] = Level(static_cast<int>(random() % static_cast<unsigned>(most + 1)));
    }
    TexelStore store(format, levels, std::vector<std::byte>(format.texelBytes()));
    std::uniform_real_distribution<float> in(0, 1);
    for (std::size_t f = 0; f < faces; ++f) {
        if (f % 4 == 3) {
            continue; // stays constant
        }
        const std::span<std::byte> texels = store.writable(faceId(f));
        std::vector<float> values(texels.size() / byteSize(format.type));
        for (float& value : values) {
            value = in(random);
        }
        encode(format.type, values, texels);
    }
    return store;
}

struct Tile
{
    AtlasTile shape;
    std::vector<std::byte> bytes;
    std::size_t texelBytes;

    Tile(const AtlasTexels& texels, FaceId face, Level level, AtlasBorder border)
        : shape(level, border)
        , texelBytes(texels.format().texelBytes())
    {
        bytes.resize(texelBytes * shape.side() * shape.side(), std::byte{0xcd});
        texels.fill(face, shape, bytes.data(), texelBytes * shape.side());
    }
    std::span<const std::byte> at(AtlasPixel pixel) const
    {
        return std::span(bytes).subspan(
            (std::size_t{pixel.y} * shape.side() + pixel.x) * texelBytes, texelBytes);
    }
    float value(AtlasPixel pixel) const
    {
        float result = 0;
        std::memcpy(&result, at(pixel).data(), 4);
        return result;
    }
};

TEST(AtlasTexels, whatIsTransparentLendsCoarserLevelsNoColor)
{
    const TriangleMesh mesh = turnedGrid(1, 1);
    const TexelFormat format{TexelType::Float, 2, 1};
    TexelStore store(format, FaceMap<Level>(2, Level(1)), std::vector<std::byte>(8));
    const std::array<float, 8> values = {0.75F, 1, 9, 0, 0.25F, 1, 9, 0};
    std::ranges::copy(std::as_bytes(std::span(values)), store.writable(faceId(0)).begin());
    AtlasTexels texels(store, buildAdjacency(mesh.triangles));
    texels.coarsen(Threads{1});
    const Tile tile(texels, faceId(0), Level(), AtlasBorder::None);
    std::array<float, 2> mean{};
    decode(TexelType::Float, tile.at({0, 0}), mean);
    EXPECT_EQ(mean, (std::array{0.5F, 0.5F}));
}

TEST(AtlasTexels, everyTexelOfEveryLevelIsThereToTheBit)
{
    const TriangleMesh mesh = turnedGrid(3, 1);
    const Adjacency adjacency = buildAdjacency(mesh.triangles);
    for (const TexelFormat& format : {TexelFormat{TexelType::UInt8, 3, std::nullopt},
                                      TexelFormat{TexelType::Half, 4, std::nullopt},
                                      kOneFloat}) {
        const TexelStore store = randomStore(mesh.faceCount(), format, 6, 2);
        AtlasTexels texels(store, adjacency);
        while (true) {
            for (std::size_t f = 0; f < mesh.faceCount(); ++f) {
                const FaceTexels& base = store.face(faceId(f));
                if (base.level() < texels.level()) {
                    continue;
                }
                const FaceTexels expected =
                    reduced(format, base, base.level().log2() - texels.level().log2());
                for (const AtlasBorder border : {AtlasBorder::None, AtlasBorder::Bilinear}) {
                    const Tile tile(texels, faceId(f), texels.level(), border);
                    for (std::uint32_t k = 0; k < texels.level().texelCount(); ++k) {
                        const TexelCoord at = texelAt(texels.level(), TexelIndex(k));
                        const auto stored = tile.at(tile.shape.pixel({at.i, at.j, at.half}));
                        ASSERT_TRUE(std::ranges::equal(stored, expected.texel(k)));
                    }
                }
            }
            if (texels.level() == Level()) {
                break;
            }
            texels.coarsen(Threads{1});
        }
    }
}

/// A flat mesh goes on across its edges, whichever of them meet: borders that are of the true
/// neighbours, and of the right texels of them, go on with it.
TEST(AtlasTexels, bordersContinueAnAffineFunction)
{
    const TriangleMesh mesh = turnedGrid(5, 4);
    const Adjacency adjacency = buildAdjacency(mesh.triangles);
    for (const int n : {1, 2, 4}) {
        const TexelStore store = affineStore(mesh, Level(n));
        const AtlasTexels texels(store, adjacency);
        int checked = 0;
        for (std::size_t f = 0; f < mesh.faceCount(); ++f) {
            const Tile tile(texels, faceId(f), Level(n), AtlasBorder::Bilinear);
            for (std::uint32_t y = 0; y < tile.shape.side(); ++y) {
                for (std::uint32_t x = 0; x < tile.shape.side(); ++x) {
                    const LatticeCell cell = tile.shape.cell({x, y});
                    const double third = cell.half == TexelHalf::Lower ? 1.0 / 3 : 2.0 / 3;
                    const glm::dvec2 uv =
                        glm::dvec2(cell.i + third, cell.j + third) / double(Level(n).resolution());
                    const glm::vec3 point = pointOf(mesh, faceId(f), uv);
                    if (point.x < 0 || point.y < 0 || point.x > 5 || point.y > 5) {
                        continue; // beyond the mesh
                    }
                    ++checked;
                    EXPECT_NEAR(tile.value({x, y}), affine(point), 1e-4);
                }
            }
        }
        EXPECT_GT(checked, 50 * static_cast<int>(Level(n).texelCount()));
    }
}

TEST(AtlasTexels, neighboursOfOtherLevelsGiveTheirTexelUnderTheCell)
{
    const TriangleMesh mesh = turnedGrid(1, 9); // two faces
    const Adjacency adjacency = buildAdjacency(mesh.triangles);
    FaceMap<Level> levels(2);
    levels[faceId(0)] = Level(4);
    levels[faceId(1)] = Level(1);
    const std::array<std::byte, 4> black{};
    const TexelStore store(kOneFloat, levels, black);
    AtlasTexels texels(store, adjacency);
    const AtlasTile tile(Level(4), AtlasBorder::Bilinear);
    for (std::uint32_t y = 0; y < tile.side(); ++y) {
        for (std::uint32_t x = 0; x < tile.side(); ++x) {
            const AtlasSource from = texels.source(faceId(0), tile.cell({x, y}));
            EXPECT_EQ(from.level, levels[from.face]);
            EXPECT_TRUE(isValid(from.level, from.texel));
        }
    }
    texels.coarsen(Threads{1});
    EXPECT_EQ(texels.source(faceId(0), {0, 0, TexelHalf::Lower}).level, Level(3));
    EXPECT_EQ(texels.source(faceId(1), {0, 0, TexelHalf::Lower}).level, Level(1));
}

TEST(AtlasTexels, aBorderOfTheMeshRepeatsTheNearestTexels)
{
    const TriangleMesh mesh{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}, {}};
    const Adjacency adjacency = buildAdjacency(mesh.triangles);
    const TexelStore store = affineStore(mesh, Level(3));
    const AtlasTexels texels(store, adjacency);
    const LatticeCell below{3, -1, TexelHalf::Upper}; // shares its upper edge with lower (3,0)…
    const AtlasSource from = texels.source(faceId(0), below);
    EXPECT_EQ(from.texel.j, 0);
    EXPECT_LE(std::abs(int(from.texel.i) - 3), 1);
    const Tile tile(texels, faceId(0), Level(3), AtlasBorder::Bilinear);
    for (std::uint32_t y = 0; y < tile.shape.side(); ++y) {
        for (std::uint32_t x = 0; x < tile.shape.side(); ++x) {
            EXPECT_TRUE(std::abs(tile.value({x, y})) < 100); // nothing is left unset
        }
    }
}

} // namespace

namespace {

/// Faces of a store in memory, as if they lay in a file.
class StoreReader final : public FaceReader
{
public:
    explicit StoreReader(TexelStore store)
        : m_store(std::move(store))
    {
    }

    Result<bool> read(FaceId face, Level /*level*/, std::span<std::byte> texels) const override
    {
        std::ranges::copy(m_store.face(face).bytes(), texels.begin());
        return true;
    }
    bool stores(FaceId /*face*/, Level /*level*/) const override { return false; }
    std::span<const std::byte> mean(FaceId face) const override
    {
        return m_store.face(face).texel(0);
    }

private:
    TexelStore m_store;
};

} // namespace

TEST(AtlasTexels, holdNoneOfTheFacesThatLieInAFile)
{
    const TriangleMesh mesh = turnedGrid(3, 1);
    const Adjacency adjacency = buildAdjacency(mesh.triangles);
    const TexelFormat format;
    TexelStore memory = randomStore(mesh.faceCount(), format, 4, 6);
    for (std::size_t f = 0; f < mesh.faceCount(); ++f) {
        (void)memory.writable(faceId(f));
    }
    const auto stored = StoredFaces::make(format, std::make_unique<StoreReader>(memory), 0);
    TexelStore onDemand = memory;
    for (std::size_t f = 0; f < mesh.faceCount(); ++f) {
        onDemand.exchange(faceId(f), stored->face(faceId(f), memory.face(faceId(f)).level()));
    }
    const AtlasTexels expected(memory, adjacency);
    const AtlasTexels texels(onDemand, adjacency);
    for (std::size_t f = 0; f < mesh.faceCount(); ++f) {
        const AtlasTile tile(texels.levelOf(faceId(f)), AtlasBorder::Bilinear);
        const std::size_t stride = tile.side() * format.texelBytes();
        std::vector<std::byte> one(tile.side() * stride);
        std::vector<std::byte> other(one.size());
        texels.fill(faceId(f), tile, one.data(), stride);
        expected.fill(faceId(f), tile, other.data(), stride);
        ASSERT_EQ(one, other) << f;
    }
    EXPECT_GT(stored->readBytes(), 0U);
    EXPECT_EQ(stored->heldBytes(), 0U);
    EXPECT_EQ(stored->cachedBytes(), 0U);
}
