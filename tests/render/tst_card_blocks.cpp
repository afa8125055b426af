// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/card_blocks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <string_view>

using namespace trixel;
using namespace trixel::render;

namespace {

/// A buffer whose elements say whose they are: what the card would hold.
class Model
{
public:
    explicit Model(CardBlocks& blocks)
        : m_blocks(blocks)
    {
    }

    /// Copies as the card would, then writes the blocks that got new contents.
    void follow(const std::vector<FaceId>& written)
    {
        m_elements.resize(m_blocks.capacity());
        for (const CardBlocks::Move& move : m_blocks.takeMoves()) {
            ASSERT_LE(move.from + move.count, m_blocks.capacity());
            ASSERT_LE(move.to + move.count, m_blocks.capacity());
            const std::uint32_t distance =
                std::max(move.from, move.to) - std::min(move.from, move.to);
            ASSERT_GE(distance, move.count) << "ranges of a move overlap";
            std::copy_n(m_elements.begin() + move.from, move.count, m_elements.begin() + move.to);
        }
        for (const FaceId face : written) {
            write(face);
        }
    }

    void write(FaceId face)
    {
        const FaceRecord& record = m_blocks.record(face);
        const std::uint32_t count = elementsOf(m_blocks.kind(), Level(record.level()));
        for (std::uint32_t k = 0; k < count; ++k) {
            m_elements[record.offset + k] = valueOf(face, k);
        }
    }

    void writeBases()
    {
        m_elements.resize(m_blocks.capacity());
        const std::uint32_t count = elementsOf(m_blocks.kind(), Level());
        for (std::size_t f = 0; f < m_blocks.faceCount(); ++f) {
            for (std::uint32_t k = 0; k < count; ++k) {
                m_elements[m_blocks.baseOffset(faceId(f)) + k] = valueOf(faceId(f), k);
            }
        }
    }

    /// Every face finds its own elements: no block overlaps another, nothing got lost.
    void expectWhole() const
    {
        std::uint64_t used = 0;
        for (std::size_t f = 0; f < m_blocks.faceCount(); ++f) {
            const FaceRecord& record = m_blocks.record(faceId(f));
            const std::uint32_t count = elementsOf(m_blocks.kind(), Level(record.level()));
            ASSERT_LE(record.offset + count, m_blocks.capacity());
            for (std::uint32_t k = 0; k < count; ++k) {
                ASSERT_EQ(m_elements[record.offset + k], valueOf(faceId(f), k)) << f << " " << k;
            }
            used += m_blocks.hasBlock(faceId(f)) ? count : 0;
            used += elementsOf(m_blocks.kind(), Level());
        }
        ASSERT_EQ(m_blocks.used(), used);
        ASSERT_LE(m_blocks.used(), m_blocks.reserved());
        ASSERT_LE(m_blocks.reserved(), m_blocks.capacity());
    }

private:
    static std::uint32_t valueOf(FaceId face, std::uint32_t k)
    {
        return (static_cast<std::uint32_t>(face) + 1) * 2654435761U + k;
    }

    CardBlocks& m_blocks;
    std::vector<std::uint32_t> m_elements;
};

/// Elements of the shelf that a class needs beside those in use, and of what one leaves over.
std::uint64_t boundOf(const CardBlocks& blocks)
{
    std::array<std::uint64_t, Level::kMax + 1> count{};
    for (std::size_t f = 0; f < blocks.faceCount(); ++f) {
        const FaceRecord& record = blocks.record(faceId(f));
        count[static_cast<std::size_t>(record.level())] += blocks.hasBlock(faceId(f)) ? 1 : 0;
    }
    std::uint64_t sum = blocks.faceCount() * elementsOf(blocks.kind(), Level());
    for (int level = 1; level <= Level::kMax; ++level) {
        if (const std::uint64_t n = count[static_cast<std::size_t>(level)]; n > 0) {
            const CardBlocks::ShelfSize shelf = blocks.shelfOf(Level(level));
            sum += (n + shelf.blocks - 1) / shelf.blocks * shelf.elements;
        }
    }
    return sum;
}

class BlocksOfAKind : public testing::TestWithParam<BlockKind>
{
};

} // namespace

TEST_P(BlocksOfAKind, keepWhatTheyHoldThroughAnyChange)
{
    for (const unsigned seed : {1U, 2U, 3U}) {
        std::mt19937 random(seed);
        constexpr std::size_t kFaces = 400;
        CardBlocks blocks(GetParam(), kFaces, 60'000);
        Model model(blocks);
        model.writeBases();
        int refused = 0;
        for (int round = 0; round < 300; ++round) {
            std::vector<FaceId> written;
            for (int k = 0; k < 20; ++k) {
                const FaceId face = faceId(random() % kFaces);
                const int most = random() % 50 == 0 ? 8 : 6;
                const int level = round % 60 < 40 ? static_cast<int>(random() % most) : 0;
                const FaceRecord before = blocks.record(face);
                if (blocks.resize(face, Level(level))) {
                    ASSERT_EQ(blocks.record(face).level(), level);
                    const bool keepsPrefix =
                        GetParam() == BlockKind::Vertices && level <= before.level();
                    if (!keepsPrefix && level > 0) {
                        written.push_back(face);
                    }
                } else {
                    ++refused;
                    ASSERT_EQ(blocks.record(face).level(), before.level());
                }
            }
            if (round % 7 == 0) {
                blocks.compact(random() % 30);
            }
            if (round % 13 == 0) {
                blocks.compact();
                ASSERT_LE(blocks.reserved(), boundOf(blocks));
            }
            model.follow(written);
            if (round % 5 == 0) {
                model.expectWhole();
            }
        }
        EXPECT_GT(refused, 0) << "the buffer was never full";
        for (std::size_t f = 0; f < kFaces; ++f) {
            blocks.release(faceId(f));
        }
        blocks.compact();
        EXPECT_EQ(blocks.used(), blocks.reserved());
        model.follow({});
        model.expectWhole();
    }
}

TEST_P(BlocksOfAKind, findRoomWheneverEnoughPagesAreFreeAnywhere)
{
    constexpr std::size_t kFaces = 12'000;
    CardBlocks blocks(GetParam(), kFaces, 300'000);
    Model model(blocks);
    model.writeBases();
    // Shelves of two classes by turns until all is full; then one class goes.
    std::vector<FaceId> kept;
    std::vector<FaceId> gone;
    std::size_t next = 0;
    for (bool isFull = false; !isFull;) {
        for (const int level : {2, 3}) {
            for (std::uint32_t k = 0; k < blocks.shelfOf(Level(level)).blocks && !isFull; ++k) {
                ASSERT_LT(next, kFaces);
                isFull = !blocks.resize(faceId(next), Level(level));
                if (!isFull) {
                    (level == 2 ? kept : gone).push_back(faceId(next++));
                }
            }
        }
    }
    for (const FaceId face : gone) {
        blocks.release(face);
    }
    model.follow(kept);
    std::size_t given = 0;
    for (int level = 8; level >= 5; --level) {
        for (std::size_t f = 0; f < kFaces; ++f) {
            if (blocks.record(faceId(f)).level() > 0) {
                continue;
            }
            const CardBlocks::ShelfSize shelf = blocks.shelfOf(Level(level));
            const std::uint64_t free = blocks.capacity() - blocks.reserved();
            const bool found = blocks.resize(faceId(f), Level(level));
            // Beyond the last whole run, and before the first page.
            EXPECT_TRUE(found || free < 2 * shelf.elements) << level << " " << free;
            given += found ? 1 : 0;
            model.follow(found ? std::vector{faceId(f)} : std::vector<FaceId>{});
            if (!found) {
                break;
            }
        }
    }
    EXPECT_GE(given, 2U);
    model.expectWhole();
}

/// Sixteen pages of 32 are free, eight at most in a row: one run is cleared by moving a shelf of
/// four pages, for which another has to be cleared first.
TEST(CardBlocks, roomForARunIsMadeByMovingWhatIsInTheWayOfWhatIsInTheWay)
{
    constexpr const char* kQuads = "KDDD KDDD KDDD KKDD KKDD KKDD KKKD"; // kept or given back
    constexpr std::size_t kFaces = 1 + 12 + 16 * 4 + 1;
    CardBlocks blocks(BlockKind::Texels, kFaces, 128 + 32 * 64);
    ASSERT_EQ(blocks.heapElements(), 32U * 64U);
    ASSERT_EQ(blocks.shelfOf(Level(4)).elements, 4U * 64U);
    ASSERT_EQ(blocks.shelfOf(Level(5)).elements, 16U * 64U);
    Model model(blocks);
    model.writeBases();
    std::vector<FaceId> kept;
    std::vector<FaceId> given;
    std::uint32_t next = 0;
    const auto place = [&](int level, std::vector<FaceId>& to) {
        to.push_back(faceId(next++));
        ASSERT_TRUE(blocks.resize(to.back(), Level(level)));
    };
    place(4, kept);
    for (const char page : std::string_view(kQuads)) {
        if (page == 'K') {
            place(3, kept); // a page
        }
        for (int k = 0; page == 'D' && k < 4; ++k) {
            place(2, given); // a quarter of one
        }
    }
    model.follow(kept);
    for (const FaceId face : given) {
        blocks.release(face);
    }
    blocks.compact();
    model.follow({});
    model.expectWhole();
    ASSERT_EQ(blocks.capacity() - blocks.reserved(), 16U * 64U + 128 - kFaces);
    const FaceId large = faceId(next);
    ASSERT_TRUE(blocks.resize(large, Level(5)));
    model.follow({large});
    model.expectWhole();
    EXPECT_EQ(blocks.reserved(), blocks.capacity() - (128 - kFaces)); // not a page is left
    EXPECT_FALSE(blocks.resize(given.front(), Level(2)));
    model.expectWhole();
}

INSTANTIATE_TEST_SUITE_P(Both,
                         BlocksOfAKind,
                         testing::Values(BlockKind::Texels, BlockKind::Vertices),
                         [](const auto& kind) {
                             return kind.param == BlockKind::Texels ? "texels" : "vertices";
                         });

TEST(CardBlocks, blocksHaveTheSizesOfTheirKind)
{
    EXPECT_EQ(elementsOf(BlockKind::Texels, Level(3)), 64U);
    EXPECT_EQ(elementsOf(BlockKind::Vertices, Level(0)), 3U);
    EXPECT_EQ(elementsOf(BlockKind::Vertices, Level(2)), 3U + 6U + 15U);
    EXPECT_EQ(firstVertexOf(Level(0)), 0U);
    EXPECT_EQ(firstVertexOf(Level(2)), 3U + 6U);
}

TEST(CardBlocks, shelvesOfTexelsLeaveNothingOverAndOfVerticesLittle)
{
    const CardBlocks texels(BlockKind::Texels, 1'000'000, 1U << 27U);
    const CardBlocks vertices(BlockKind::Vertices, 1'000'000, 1U << 26U);
    for (int level = 1; level <= Level::kMax; ++level) {
        const auto exact = texels.shelfOf(Level(level));
        EXPECT_EQ(exact.elements, exact.blocks * elementsOf(BlockKind::Texels, Level(level)));
        const auto some = vertices.shelfOf(Level(level));
        const double used =
            static_cast<double>(some.blocks) * elementsOf(BlockKind::Vertices, Level(level));
        EXPECT_GT(used, (level <= 8 ? 0.84 : 0.66) * some.elements) << level;
    }
}

TEST(CardBlocks, aBufferThatGrowsKeepsItsBlocks)
{
    CardBlocks blocks(BlockKind::Texels, 100, 4000);
    Model model(blocks);
    model.writeBases();
    std::vector<FaceId> written;
    std::size_t f = 0;
    for (; f < 100 && blocks.resize(faceId(f), Level(3)); ++f) {
        written.push_back(faceId(f));
    }
    ASSERT_LT(f, 100U);
    model.follow(written);
    blocks.grow(100 + 64 * 110);
    for (written.clear(); f < 100; ++f) {
        ASSERT_TRUE(blocks.resize(faceId(f), Level(3)));
        written.push_back(faceId(f));
    }
    model.follow(written);
    model.expectWhole();
}

TEST(CardBlocks, nothingMovesWhereNoShelfCouldGo)
{
    constexpr std::uint32_t kFaces = 4000;
    CardBlocks blocks(BlockKind::Texels, kFaces, kFaces + 4000);
    std::uint32_t count = 0; // all the room is theirs
    while (count + 1 < kFaces && blocks.resize(faceId(count), Level(1))) {
        ++count;
    }
    const std::uint32_t shelf = blocks.shelfOf(Level(1)).blocks;
    ASSERT_GT(shelf, 1U);
    ASSERT_GE(count, 2 * shelf);
    (void)blocks.takeMoves();
    for (std::uint32_t f = 1; f < shelf; ++f) {
        blocks.release(faceId(f));
    }
    const FaceId other = faceId(kFaces - 1);
    EXPECT_FALSE(blocks.resize(other, Level(2))); // would need a shelf of its own
    EXPECT_TRUE(blocks.takeMoves().empty());
    blocks.compact();
    EXPECT_TRUE(blocks.takeMoves().empty());
    blocks.release(faceId(count - 1));
    EXPECT_TRUE(blocks.resize(other, Level(2)));
    EXPECT_FALSE(blocks.takeMoves().empty());
}

TEST(CardBlocks, everyFaceHasItsBaseEvenWithoutAnyOtherRoom)
{
    CardBlocks blocks(BlockKind::Vertices, 50, 0);
    EXPECT_EQ(blocks.capacity(), 150U);
    EXPECT_EQ(blocks.baseOffset(faceId(49)), 147U);
    EXPECT_TRUE(blocks.record(faceId(49)).isPending());
    EXPECT_FALSE(blocks.resize(faceId(49), Level(1)));
    EXPECT_TRUE(blocks.resize(faceId(49), Level(0)));
    EXPECT_FALSE(blocks.record(faceId(49)).isPending());
}

TEST(CardBlocks, changedRecordsAreToldOnceAndInOrder)
{
    CardBlocks blocks(BlockKind::Texels, 50, 5000);
    blocks.mark(faceId(30), FaceRecord::kConstant | 5U << FaceRecord::kOwnShift);
    EXPECT_TRUE(blocks.resize(faceId(20), Level(2)));
    EXPECT_TRUE(blocks.resize(faceId(20), Level(3)));
    EXPECT_EQ(blocks.takeChanged(), (std::vector<std::uint32_t>{20, 30}));
    EXPECT_TRUE(blocks.takeChanged().empty());
    EXPECT_TRUE(blocks.record(faceId(30)).isConstant());
    EXPECT_EQ(blocks.record(faceId(30)).ownLevel(), 5);
    blocks.mark(faceId(20), blocks.record(faceId(20)).bits);
    EXPECT_TRUE(blocks.takeChanged().empty());
}
