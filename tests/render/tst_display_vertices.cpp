// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/texture/face_vertices.h"
#include "render/display_vertices.h"
#include "tests/core/filter/random_scene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>

using namespace trixel;
using namespace trixel::render;
using namespace trixel::test;

namespace {

constexpr std::size_t kVertexBytes = 4;

/// What the card holds after updates.
struct Card
{
    std::vector<std::byte> vertices;
    std::vector<FaceRecord> records;

    void take(DisplayVertices& layout, const TexelStore& store, std::size_t budget)
    {
        const DisplayUpdate update = layout.take(store, budget);
        if (update.fresh) {
            vertices.assign(update.capacity * kVertexBytes, std::byte{0xAA});
            records.assign(layout.records().begin(), layout.records().end());
        }
        vertices.resize(update.capacity * kVertexBytes);
        for (const CardBlocks::Move& move : update.moves) {
            std::memcpy(vertices.data() + move.to * kVertexBytes,
                        vertices.data() + move.from * kVertexBytes,
                        move.count * kVertexBytes);
        }
        const std::byte* bytes = update.bytes.data();
        for (const DisplayUpdate::Range& range : update.texels) {
            ASSERT_LE(range.first + range.count, update.capacity);
            std::memcpy(
                vertices.data() + range.first * kVertexBytes, bytes, range.count * kVertexBytes);
            bytes += range.count * kVertexBytes;
        }
        ASSERT_EQ(bytes, update.bytes.data() + update.bytes.size());
        for (const DisplayUpdate::Range& range : update.records) {
            for (std::uint32_t k = range.first; k < range.first + range.count; ++k) {
                records[k] = layout.records()[k];
            }
        }
    }
};

/// Every face's block, made with nothing kept from before, is what its record points to.
void expectWhole(const Card& card, const FilterMesh& mesh, const TexelStore& store)
{
    ChainCache chains({0, 1, 2, -1}, 1U << 24U);
    const FaceMips mips(store, chains);
    const FaceVertices vertices(mips, mesh.adjacency(), mesh.rings());
    for (std::size_t f = 0; f < store.faceCount(); ++f) {
        const FaceRecord& record = card.records[f];
        ASSERT_FALSE(record.isPending()) << f;
        if (!vertices.isConstant(faceId(f))) {
            ASSERT_EQ(record.level(), vertices.level(faceId(f)).log2()) << f;
        }
        std::vector<std::byte> block;
        vertices.appendBlock(faceId(f), Level(record.level()), block);
        ASSERT_LE(record.offset * kVertexBytes + block.size(), card.vertices.size());
        ASSERT_TRUE(std::equal(
            block.begin(), block.end(), card.vertices.begin() + record.offset * kVertexBytes))
            << "face " << f << " level " << record.level();
    }
}

} // namespace

TEST(DisplayVertices, holdOneRedTexelWhereItIsAndNowhereElse)
{
    const TriangleMesh mesh = flatLattice(8);
    const std::array<std::byte, 3> grey{std::byte{204}, std::byte{204}, std::byte{204}};
    TexelStore store(static_cast<std::uint32_t>(mesh.faceCount()), TexelFormat{}, Level(3), grey);
    const auto texels = store.writable(faceId(20));
    texels[0] = std::byte{255};
    texels[1] = texels[2] = std::byte{0};
    const auto filterMesh =
        std::make_shared<const FilterMesh>(mesh, buildAdjacency(mesh.triangles), store);
    for (const std::size_t budget : {std::size_t{1}, std::size_t{1000}, std::size_t{1} << 20U}) {
        DisplayVertices layout;
        layout.reset(filterMesh, store, 0, 1U << 27U);
        Card card;
        while (layout.hasWork()) {
            card.take(layout, store, budget);
        }
        expectWhole(card, *filterMesh, store);
    }
}

TEST(DisplayVertices, followStrokes)
{
    Random random(4);
    const TriangleMesh mesh = flatLattice(6);
    const std::array<std::byte, 3> grey{std::byte{90}, std::byte{90}, std::byte{90}};
    TexelStore store(static_cast<std::uint32_t>(mesh.faceCount()), TexelFormat{}, Level(4), grey);
    const auto filterMesh =
        std::make_shared<const FilterMesh>(mesh, buildAdjacency(mesh.triangles), store);
    DisplayVertices layout;
    layout.reset(filterMesh, store, 0, 1U << 27U);
    Card card;
    while (layout.hasWork()) {
        card.take(layout, store, 1000);
    }
    for (int stroke = 0; stroke < 8; ++stroke) {
        std::vector<TouchedRect> rects;
        for (int k = 0; k < 4; ++k) {
            TouchedRect rect{faceId(random() % mesh.faceCount())};
            rect.x = static_cast<std::uint16_t>(random() % 14);
            rect.y = static_cast<std::uint16_t>(random() % 14);
            rect.width = rect.height = 2;
            rect.wholeFace = store.face(rect.face).isConstant();
            const auto texels = store.writable(rect.face);
            for (std::size_t y = rect.y; y < rect.y + 2U; ++y) {
                for (std::size_t b = 0; b < 6; ++b) {
                    texels[3 * (rect.x + 16 * y) + b] = static_cast<std::byte>(random());
                }
            }
            rects.push_back(rect);
        }
        layout.touch(store, rects);
        while (layout.hasWork()) {
            card.take(layout, store, 1000);
        }
        expectWhole(card, *filterMesh, store);
    }
}
