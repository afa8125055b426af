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
/// \param finest  whether it is to be of the face's own level
void expectWhole(const Card& card,
                 const FilterMesh& mesh,
                 const TexelStore& store,
                 bool finest = true)
{
    ChainCache chains({0, 1, 2, -1}, 1U << 24U);
    const FaceMips mips(store, chains);
    const FaceVertices vertices(mips, mesh.adjacency(), mesh.rings());
    for (std::size_t f = 0; f < store.faceCount(); ++f) {
        const FaceRecord& record = card.records[f];
        ASSERT_FALSE(record.isPending()) << f;
        if (finest && !vertices.isConstant(faceId(f))) {
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

/// Noise all over.
TexelStore noise(const TriangleMesh& mesh, Level level)
{
    Random random(7);
    TexelStore store(static_cast<std::uint32_t>(mesh.faceCount()),
                     TexelFormat{},
                     level,
                     std::array<std::byte, 3>{});
    for (std::size_t f = 0; f < store.faceCount(); ++f) {
        for (std::byte& value : store.writable(faceId(f))) {
            value = static_cast<std::byte>(random());
        }
    }
    return store;
}

/// That of a view which shows the first half of the faces at one level, the others at another.
/// \param first, second  or `kUnseen`
ResidencyPlan planFor(const DisplayVertices& layout, int first, int second)
{
    const auto wish = [](int level) {
        return static_cast<Wish>(level == kUnseen ? kUnseen : 8 * level);
    };
    std::vector<Wish> wishes(layout.facesOnCard().size(), wish(first));
    std::fill(wishes.begin() + static_cast<std::ptrdiff_t>(wishes.size() / 2),
              wishes.end(),
              wish(second));
    return planResidency(wishes, layout.facesOnCard(), layout.mostRoom());
}

/// Very many faces of level 2 in little room, streamed as a view does.
class Crowd
{
public:
    struct Copies
    {
        std::size_t all = 0;
        std::size_t mostAtOnce = 0; ///< with one update
    };

    /// \param room  for vertices, a face of all
    explicit Crowd(std::uint32_t room)
        : m_mesh(flatLattice(120))
        , m_store(noise(m_mesh, Level(2)))
    {
        m_layout.reset(
            std::make_shared<const FilterMesh>(m_mesh, buildAdjacency(m_mesh.triangles), m_store),
            m_store,
            0,
            static_cast<std::uint32_t>(room * m_mesh.faceCount()));
        (void)m_layout.take(m_store, 1); // bases
    }

    std::size_t half() const { return m_mesh.faceCount() / 2; }
    std::size_t blocks(int level) const { return m_layout.blocks().blockCount(Level(level)); }

    /// Brings all that a view needs, sixteen batches an update.
    Copies see(int first, int second)
    {
        m_layout.follow(planFor(m_layout, first, second));
        const DisplayBlocks::Maker make = m_layout.maker();
        Copies copies;
        while (m_layout.hasReady() || m_layout.hasJobs()) {
            std::vector<JobBatch> batches(16);
            for (JobBatch& batch : batches) {
                batch = m_layout.nextJobs(256U << 10U);
            }
            for (const JobBatch& batch : batches) {
                m_layout.accept(make(m_store, batch.jobs), batch, m_store);
            }
            const std::size_t moves = m_layout.takeReady(m_store, 0).moves.size();
            copies.all += moves;
            copies.mostAtOnce = std::max(copies.mostAtOnce, moves);
        }
        return copies;
    }

private:
    TriangleMesh m_mesh;
    TexelStore m_store;
    DisplayVertices m_layout;
};

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

TEST(DisplayVertices, showPaintOnFacesThatLoseTheirBlocks)
{
    const TriangleMesh mesh = flatLattice(6);
    TexelStore store = noise(mesh, Level(4));
    const auto filterMesh =
        std::make_shared<const FilterMesh>(mesh, buildAdjacency(mesh.triangles), store);
    DisplayVertices layout;
    layout.reset(filterMesh, store, 0, 12'000); // for about half of the blocks
    Card card;
    const auto see = [&](int first, int second) {
        layout.follow(planFor(layout, first, second));
        while (layout.hasWork()) {
            card.take(layout, store, 1000);
        }
    };
    card.take(layout, store, 1); // bases
    see(4, kUnseen);
    ASSERT_TRUE(layout.blocks().hasBlock(faceId(0)));
    std::ranges::fill(store.writable(faceId(0)), std::byte{255});
    layout.touch(store, std::array{TouchedRect{faceId(0), 0, 0, 16, 16}});
    while (layout.hasWork()) {
        card.take(layout, store, 1000);
    }
    see(kUnseen, 4);
    ASSERT_FALSE(layout.blocks().hasBlock(faceId(0)));
    expectWhole(card, *filterMesh, store, false);
}

TEST(DisplayVertices, areNotCopiedForFacesThatLeaveTheView)
{
    Crowd crowd(3 + 14); // room for finest blocks of half the faces
    crowd.see(2, kUnseen);
    const Crowd::Copies copies = crowd.see(kUnseen, 2);
    EXPECT_GT(crowd.blocks(2), crowd.half() * 9 / 10);
    EXPECT_LT(copies.all, crowd.half() / 2); // but for what closes gaps
}

TEST(DisplayVertices, areCopiedWithoutHurryWhereManyFacesBecomeCoarser)
{
    Crowd crowd(3 + 20); // and for coarser ones of the others
    crowd.see(2, 1);
    const Crowd::Copies copies = crowd.see(1, 2);
    EXPECT_GT(crowd.blocks(2), crowd.half() * 9 / 10);
    EXPECT_GT(copies.all, crowd.half() * 9 / 10);
    EXPECT_LE(copies.mostAtOnce, 5000U);
}
