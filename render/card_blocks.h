// SPDX-License-Identifier: GPL-3.0-or-later
//
// Which block of elements on the graphics card belongs to which face. Plain data, no OpenGL.
#pragma once

#include "core/base/ids.h"
#include "core/base/level.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <set>
#include <span>
#include <vector>

namespace trixel::render {

/// What a face's block holds.
enum class BlockKind : std::uint8_t {
    Texels,  ///< the packed texels of one level
    Vertices ///< the lattice vertices of levels 0 to L, coarse first: a coarser block is a prefix
};

/// Lattice vertices of one level: (R+1)(R+2)/2.
constexpr std::uint32_t latticeVertices(Level level)
{
    const std::uint32_t r = level.resolution();
    return (r + 1) * (r + 2) / 2;
}

/// Elements of a face's block.
constexpr std::uint32_t elementsOf(BlockKind kind, Level level)
{
    if (kind == BlockKind::Texels) {
        return level.texelCount();
    }
    std::uint32_t count = 0;
    for (int k = 0; k <= level.log2(); ++k) {
        count += latticeVertices(Level(k));
    }
    return count;
}

/// Where in a block of lattice vertices those of one level begin.
constexpr std::uint32_t firstVertexOf(Level level)
{
    return level.log2() == 0 ? 0 : elementsOf(BlockKind::Vertices, level.coarser());
}

/// What the shader knows of a face.
struct FaceRecord
{
    static constexpr std::uint32_t kLevelMask = 0xff;
    static constexpr std::uint32_t kConstant = 0x100; ///< one texel stands for all
    static constexpr std::uint32_t kPending = 0x200;  ///< nothing of it has been sent yet
    /// From this bit on: the level that the face has (as asked for); what is on the card may be
    /// coarser.
    static constexpr std::uint32_t kOwnShift = 16;

    std::uint32_t offset = 0; ///< first element of the face
    std::uint32_t bits = kPending;

    /// Flags and own level, with no block's level.
    static constexpr std::uint32_t bitsOf(int ownLevel, bool isConstant)
    {
        return (isConstant ? kConstant : 0U) | static_cast<std::uint32_t>(ownLevel) << kOwnShift;
    }

    int level() const { return static_cast<int>(bits & kLevelMask); }
    bool isConstant() const { return (bits & kConstant) != 0; }
    bool isPending() const { return (bits & kPending) != 0; }
    int ownLevel() const { return static_cast<int>(bits >> kOwnShift & kLevelMask); }

    bool operator==(const FaceRecord&) const = default;
};

/// Shares out the elements of one buffer among faces.
///
/// Every face has for good the few elements of level 0 (`baseElements`) at the front of the buffer,
/// so that there is always something to show; behind them lies the *heap* of finer blocks, a class
/// a level. Blocks of a class lie side by side on *shelves*: runs of pages, a power of two of them.
/// When blocks are given back, blocks from the end of their class take their places (`Move`): after
/// `compact()` every class has as many shelves as it needs and no more. Shelves move where a larger
/// one needs a run of pages. So what is reserved is what is used, at most one shelf more a class,
/// and what does not fill a shelf: nothing of texels, a third of vertices at worst, mostly less
/// than an eighth; and a block finds room whenever its shelf's pages are free in any places but
/// those behind the last whole run of that size.
class CardBlocks
{
public:
    /// Elements to be copied on the card. Ranges of one move don't overlap; moves count in order,
    /// and before anything is written.
    struct Move
    {
        std::uint32_t from = 0;
        std::uint32_t to = 0;
        std::uint32_t count = 0;
    };

    CardBlocks() = default;
    /// Every face pending, with its base alone.
    /// \param capacity  elements of the buffer in all; more if the bases alone need more
    CardBlocks(BlockKind kind, std::size_t faceCount, std::uint32_t capacity);

    BlockKind kind() const { return m_kind; }
    std::size_t faceCount() const { return m_records.size(); }
    std::uint32_t capacity() const { return m_capacity; } ///< of the buffer, elements
    std::uint32_t heapElements() const;                   ///< of that, for blocks above level 0
    /// Elements in blocks, the bases included.
    std::uint32_t used() const { return m_baseEnd + m_blockElements; }
    /// Blocks of a level (1 or more).
    std::uint32_t blockCount(Level level) const
    {
        return m_classes[static_cast<std::size_t>(level.log2())].used;
    }
    /// Elements that no other class can have now, the bases included.
    std::uint32_t reserved() const;

    std::span<const FaceRecord> records() const { return m_records; }
    const FaceRecord& record(FaceId face) const { return m_records[indexOf(face)]; }
    /// Where the elements of level 0 lie for good.
    std::uint32_t baseOffset(FaceId face) const;
    std::uint32_t baseElements() const { return m_baseEnd; } ///< of all faces
    /// Whether the face has a block in the heap.
    bool hasBlock(FaceId face) const { return m_records[indexOf(face)].offset >= m_baseEnd; }

    /// Gives the face a block of this level in the place of the one it has. What is in it is
    /// undefined, but for vertices the levels that both blocks have are copied. Level 0 is the
    /// base. The face is not pending any more.
    /// \param keeps  false where what is in the block is of no use: nothing is copied
    /// \return  false, and nothing changes for this face, when there is no room
    bool resize(FaceId face, Level level, bool keeps = true);
    /// The face keeps its base alone.
    void release(FaceId face, bool keeps = true) { (void)resize(face, Level(), keeps); }
    /// Sets or clears flags and the own level of a face's record.
    /// \param bits  all but the level, which the block decides
    void mark(FaceId face, std::uint32_t bits);

    /// A shelf for blocks of a level (1 or more).
    struct ShelfSize
    {
        std::uint32_t elements = 0;
        std::uint32_t blocks = 0; ///< that it holds
    };
    ShelfSize shelfOf(Level level) const;

    /// Takes room for so many more elements. \param capacity  not fewer than before (checked)
    void grow(std::uint32_t capacity);

    /// Fills holes with blocks from the end of their class. \param most  so many moves at most
    void compact(std::size_t most = ~std::size_t{0});

    /// How much `takeMoves` would give.
    std::size_t moveCount() const { return m_moves.size(); }
    /// What is to be copied since the last time.
    std::vector<Move> takeMoves();
    /// Faces whose records changed since the last time: each once, ascending.
    std::vector<std::uint32_t> takeChanged();

private:
    static constexpr std::uint32_t kNone = ~std::uint32_t{0};
    static constexpr std::size_t kOrders = 32;

    /// The blocks of one level.
    struct Class
    {
        std::uint32_t size = 0;             ///< elements of a block
        std::uint32_t order = 0;            ///< a shelf is 2^order pages
        std::uint32_t perShelf = 0;         ///< blocks
        std::vector<std::uint32_t> shelves; ///< first page of each
        std::vector<std::uint32_t> faces;   ///< by slot; kNone is a hole
        std::vector<std::uint32_t> holes;   ///< those slots, each once, in any order
        std::uint32_t used = 0;             ///< slots with a face
    };

    Class& classOf(int level) { return m_classes[static_cast<std::size_t>(level)]; }
    std::uint32_t offsetOf(const Class& c, std::uint32_t slot) const;
    std::uint32_t slotOf(const Class& c, std::uint32_t offset) const;
    std::uint32_t takeSlot(int level);
    void giveBack(Class& c, std::uint32_t slot);
    void compact(Class& c, std::size_t& most);
    void setRecord(std::uint32_t face, std::uint32_t offset, std::uint32_t bits);

    std::uint32_t takePages(std::uint32_t order);
    void givePages(std::uint32_t first, std::uint32_t order);
    std::uint32_t findPages(std::uint32_t order);
    /// A run of 2^order pages.
    struct Run
    {
        std::uint32_t first = 0;
        std::uint32_t order = 0;
    };
    bool clearWindow(std::uint32_t order);
    bool moveOut(std::uint32_t begin, std::uint32_t order);
    bool moveShelf(const Run& run);

    BlockKind m_kind = BlockKind::Texels;
    std::uint32_t m_capacity = 0;
    std::uint32_t m_baseEnd = 0;   ///< elements of all bases
    std::uint32_t m_heapBegin = 0; ///< a whole number of pages
    std::uint32_t m_page = 1;      ///< elements
    std::uint32_t m_pages = 0;
    std::uint32_t m_freePages = 0;
    std::uint32_t m_blockElements = 0;
    std::array<Class, Level::kMax + 1> m_classes;
    std::array<std::set<std::uint32_t>, kOrders> m_free; ///< runs of 2^order pages
    static constexpr int kFree = -1;
    static constexpr int kKept = -2; ///< free, but not for what moves now
    /// What a page belongs to: a shelf by its level and its place among those of its class.
    struct Shelf
    {
        int level = kFree;
        std::uint32_t index = 0;
    };
    std::vector<Shelf> m_shelfAt; ///< by page

    std::vector<FaceRecord> m_records;
    std::vector<Move> m_moves;
    std::vector<std::uint32_t> m_changed;
    std::vector<bool> m_isChanged;
};

} // namespace trixel::render
