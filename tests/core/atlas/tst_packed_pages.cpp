// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/atlas/packed_pages.h"
#include "core/texture/mips.h"
#include "tests/core/atlas/atlas_pages.h"
#include "tests/core/cancel_after.h"

#include <gtest/gtest.h>

using namespace trixel;
using namespace trixel::test;

namespace {

/// Faces of levels 0 to 10, most of them small, some constant, of values that differ.
TexelStore anyStore(const TriangleMesh& mesh, const TexelFormat& format)
{
    FaceMap<Level> levels(mesh.faceCount());
    for (std::size_t f = 0; f < mesh.faceCount(); ++f) {
        levels[faceId(f)] = Level(f < 11 ? static_cast<int>(f) : static_cast<int>(f % 4));
    }
    TexelStore store(format, levels, std::vector<std::byte>(format.texelBytes()));
    std::mt19937 random(3);
    for (std::size_t f = 0; f < mesh.faceCount(); f += 1 + (f > 11 ? f % 3 : 0)) {
        const std::span<std::byte> texels = store.writable(faceId(f));
        std::vector<float> values(texels.size() / byteSize(format.type));
        for (float& value : values) {
            value = static_cast<float>(random() >> 8U) / 16777216.0F;
        }
        encode(format.type, values, texels);
    }
    return store;
}

TEST(PackedPages, facesComeBackToTheBitFromEveryTypeAndBorder)
{
    const TriangleMesh mesh = turnedGrid(4, 2);
    const Adjacency adjacency = buildAdjacency(mesh.triangles);
    NoProgress progress;
    for (const TexelFormat& format : {TexelFormat{TexelType::UInt8, 3, std::nullopt},
                                      TexelFormat{TexelType::Half, 4, 3},
                                      kOneFloat}) {
        const TexelStore store = anyStore(mesh, format);
        FaceMap<Level> levels(store.faceCount());
        for (std::uint32_t f = 0; f < store.faceCount(); ++f) {
            levels[faceId(f)] = store.face(faceId(f)).level();
        }
        for (const AtlasBorder border : {AtlasBorder::None, AtlasBorder::Bilinear}) {
            AtlasOptions options;
            options.border = border;
            options.mips = border == AtlasBorder::Bilinear;
            options.largestPage = 1100; // several
            const AtlasLayout layout = *AtlasLayout::plan(levels, options);
            EXPECT_GT(layout.pages().size(), 1U);
            const auto colors = uniformColors(ColorSpace::Raw, format.channels, format.alpha);
            const auto pages = packedPages(layout, store, adjacency, colors, Threads{2}, progress);
            ASSERT_TRUE(pages);
            const auto back =
                unpackedFaces(packedFaces(layout), border, *pages, Threads{2}, progress);
            ASSERT_TRUE(back);
            for (std::uint32_t f = 0; f < store.faceCount(); ++f) {
                ASSERT_EQ(back->face(faceId(f)), store.face(faceId(f))) << f;
                EXPECT_EQ(back->face(faceId(f)).isConstant(),
                          store.face(faceId(f)).collapsed().isConstant());
            }
        }
    }
}

/// Through its address function the atlas is the store, at every texel of every level.
TEST(PackedPages, theAddressFunctionFindsEveryTexelOfEveryLevel)
{
    const TriangleMesh mesh = turnedGrid(3, 5);
    const Adjacency adjacency = buildAdjacency(mesh.triangles);
    const TexelStore store = anyStore(mesh, kOneFloat);
    FaceMap<Level> levels(store.faceCount());
    for (std::uint32_t f = 0; f < store.faceCount(); ++f) {
        levels[faceId(f)] = store.face(faceId(f)).level();
    }
    AtlasOptions options;
    options.mips = true;
    const AtlasLayout layout = *AtlasLayout::plan(levels, options);
    NoProgress progress;
    const auto pages =
        packedPages(layout, store, adjacency, {ColorSpace::Raw}, Threads{2}, progress);
    ASSERT_TRUE(pages);
    for (std::uint32_t f = 0; f < store.faceCount(); ++f) {
        FaceTexels expected = store.face(faceId(f));
        while (true) {
            const Level level = expected.level();
            for (std::uint32_t k = 0; k < level.texelCount(); ++k) {
                const glm::dvec2 uv = centroid(level, texelAt(level, TexelIndex(k)));
                const AtlasTap tap = nearestTap(layout, faceId(f), level, uv);
                ASSERT_TRUE(
                    std::ranges::equal(pixelOf((*pages)[tap.page], tap.pixel), expected.texel(k)));
            }
            if (level == Level()) {
                break;
            }
            expected = reduced(kOneFloat, expected);
        }
    }
}

/// Large faces without mips: as many reports as filling takes, none for levels without tiles.
TEST(PackedPages, levelsThatNoTileIsOfAreNotMade)
{
    const TriangleMesh mesh = turnedGrid(1, 5);
    const Adjacency adjacency = buildAdjacency(mesh.triangles);
    ASSERT_EQ(mesh.faceCount(), 2U);
    TexelStore store(kOneFloat, FaceMap<Level>(2, Level(7)), std::vector<std::byte>(4));
    (void)store.writable(faceId(0));
    class Count final : public Progress
    {
    public:
        bool report(double /*fraction*/) override
        {
            ++reports;
            return true;
        }
        int reports = 0;
    };
    const auto reports = [&](const FaceMap<Level>& levels, bool mips) {
        Count progress;
        const AtlasLayout layout = *AtlasLayout::plan(levels, AtlasOptions{.mips = mips});
        EXPECT_TRUE(packedPages(layout, store, adjacency, {ColorSpace::Raw}, Threads{2}, progress));
        return progress.reports;
    };
    EXPECT_EQ(reports(FaceMap<Level>(2, Level(7)), false), 9); // 2 × 16384 texels, and the start
    EXPECT_GT(reports(FaceMap<Level>(2, Level(7)), true), 30);
    // A coarser face needs the finer one's texels at its own level, for its border.
    FaceMap<Level> mixed(2, Level(7));
    mixed[faceId(1)] = Level(5);
    store.exchange(faceId(1), store.face(faceId(1)).atLevel(Level(5)));
    EXPECT_LT(reports(mixed, false), 20);
}

/// Reducing is cancelled, too, not only filling.
TEST(PackedPages, giveUpWhenCancelledWhereverThatIs)
{
    const TriangleMesh mesh = turnedGrid(1, 5);
    const Adjacency adjacency = buildAdjacency(mesh.triangles);
    TexelStore store(kOneFloat, FaceMap<Level>(2, Level(7)), std::vector<std::byte>(4));
    (void)store.writable(faceId(0));
    (void)store.writable(faceId(1));
    const AtlasLayout layout =
        *AtlasLayout::plan(FaceMap<Level>(2, Level(7)), AtlasOptions{.mips = true});
    int reports = 0;
    for (bool isDone = false; !isDone; ++reports) {
        CancelAfter progress(reports);
        const auto pages =
            packedPages(layout, store, adjacency, {ColorSpace::Raw}, Threads{2}, progress);
        isDone = pages.has_value();
        ASSERT_TRUE(isDone || pages.error().kind == ErrorKind::Cancelled);
    }
    EXPECT_GT(reports, 8 + 8 + 2 + 2); // both of the two finest levels, at least
}

TEST(PackedPages, giveUpWhenCancelled)
{
    const TriangleMesh mesh = turnedGrid(2, 5);
    const Adjacency adjacency = buildAdjacency(mesh.triangles);
    const TexelStore store(
        kOneFloat, FaceMap<Level>(mesh.faceCount(), Level(1)), std::vector<std::byte>(4));
    const AtlasLayout layout =
        *AtlasLayout::plan(FaceMap<Level>(mesh.faceCount(), Level(1)), AtlasOptions{.mips = true});
    for (int reports = 0; reports < 4; ++reports) {
        CancelAfter progress(reports);
        const auto pages =
            packedPages(layout, store, adjacency, {ColorSpace::Raw}, Threads{1}, progress);
        ASSERT_FALSE(pages);
        EXPECT_EQ(pages.error().kind, ErrorKind::Cancelled);
    }
}

} // namespace
