// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/card_blocks.h"

#include "core/base/check.h"

#include <algorithm>
#include <bit>
#include <functional>
#include <utility>

namespace trixel::render {

namespace {

/// Pages are so large that there are a few hundred of them, within these bounds.
constexpr std::uint32_t kPagesWanted = 512;
constexpr std::uint32_t kSmallestPage = 64;
constexpr std::uint32_t kLargestPage = 1U << 14U;

std::uint32_t pageFor(std::uint32_t heap)
{
    return std::clamp(std::bit_floor(heap / kPagesWanted + 1), kSmallestPage, kLargestPage);
}

/// Order of the runs of pages that blocks of a size share: where single pages leave much over,
/// somewhat larger runs may leave less.
std::uint32_t shelfOrder(std::uint32_t size, std::uint32_t page, std::uint32_t pages)
{
    constexpr std::uint32_t kMoreOrders = 3;
    const auto waste = [&](std::uint32_t order) {
        const std::uint64_t run = std::uint64_t{page} << order;
        return static_cast<double>(run % size) / static_cast<double>(run);
    };
    std::uint32_t least = 0;
    while ((std::uint64_t{page} << least) < size) {
        ++least;
    }
    std::uint32_t best = least;
    for (std::uint32_t order = least; order <= least + kMoreOrders; ++order) {
        const bool isLarge = (std::uint64_t{1} << order) > pages / 16; // much to hold a few blocks
        if (waste(best) <= 0.125 || isLarge) {
            break;
        }
        best = waste(order) < waste(best) ? order : best;
    }
    return best;
}

/// Whether its blocks take a shelf more than they need. \param c  a class of blocks
bool hasSpareShelf(const auto& c)
{
    return !c.shelves.empty() && c.used + c.perShelf <= c.shelves.size() * c.perShelf;
}

} // namespace

CardBlocks::CardBlocks(BlockKind kind, std::size_t faceCount, std::uint32_t capacity)
    : m_kind(kind)
    , m_baseEnd(static_cast<std::uint32_t>(faceCount) * elementsOf(kind, Level()))
    , m_records(faceCount)
    , m_isChanged(faceCount)
{
    m_page = pageFor(std::max(capacity, m_baseEnd) - m_baseEnd);
    // Whole pages lie aligned, and so do blocks of texels.
    m_heapBegin = (m_baseEnd + m_page - 1) / m_page * m_page;
    grow(std::max(capacity, m_baseEnd));
    for (int level = 1; level <= Level::kMax; ++level) {
        Class& c = classOf(level);
        c.size = elementsOf(kind, Level(level));
        c.order = shelfOrder(c.size, m_page, m_pages);
        c.perShelf = (m_page << c.order) / c.size;
    }
    for (std::size_t f = 0; f < faceCount; ++f) {
        m_records[f].offset = baseOffset(faceId(f));
    }
}

std::uint32_t CardBlocks::baseOffset(FaceId face) const
{
    return static_cast<std::uint32_t>(indexOf(face)) * elementsOf(m_kind, Level());
}

std::uint32_t CardBlocks::heapElements() const
{
    return m_pages * m_page;
}

std::uint32_t CardBlocks::reserved() const
{
    return m_baseEnd + (m_pages - m_freePages) * m_page;
}

CardBlocks::ShelfSize CardBlocks::shelfOf(Level level) const
{
    const Class& c = m_classes[static_cast<std::size_t>(level.log2())];
    return {m_page << c.order, c.perShelf};
}

void CardBlocks::grow(std::uint32_t capacity)
{
    check(capacity >= m_capacity, "room for what is there");
    m_capacity = capacity;
    const std::uint32_t pages = capacity > m_heapBegin ? (capacity - m_heapBegin) / m_page : 0;
    m_shelfAt.resize(pages);
    for (std::uint32_t page = std::exchange(m_pages, pages); page < pages; ++page) {
        ++m_freePages;
        givePages(page, 0);
    }
}

// Blocks

std::uint32_t CardBlocks::offsetOf(const Class& c, std::uint32_t slot) const
{
    return m_heapBegin + c.shelves[slot / c.perShelf] * m_page + slot % c.perShelf * c.size;
}

std::uint32_t CardBlocks::slotOf(const Class& c, std::uint32_t offset) const
{
    const std::uint32_t shelf = m_shelfAt[(offset - m_heapBegin) / m_page].index;
    const std::uint32_t begin = m_heapBegin + c.shelves[shelf] * m_page;
    return shelf * c.perShelf + (offset - begin) / c.size;
}

bool CardBlocks::resize(FaceId face, Level level, bool keeps)
{
    const auto f = static_cast<std::uint32_t>(face);
    const FaceRecord before = record(face);
    const int old = hasBlock(face) ? before.level() : 0;
    const std::uint32_t flags =
        before.bits & ~(FaceRecord::kLevelMask | FaceRecord::kPending | FaceRecord::kConstant);
    const std::uint32_t bits = flags | static_cast<std::uint32_t>(level.log2());
    if (old == level.log2()) {
        setRecord(f, before.offset, bits);
        return true;
    }
    std::uint32_t offset = baseOffset(face);
    if (level.log2() > 0) {
        const std::uint32_t slot = takeSlot(level.log2());
        if (slot == kNone) {
            return false;
        }
        classOf(level.log2()).faces[slot] = f;
        offset = offsetOf(classOf(level.log2()), slot);
    }
    // Taking a slot may have moved the old block.
    const std::uint32_t from = record(face).offset;
    if (m_kind == BlockKind::Vertices && keeps) {
        const Level common = std::min(level, Level(old));
        m_moves.push_back({from, offset, elementsOf(m_kind, common)});
    }
    if (old > 0) {
        Class& c = classOf(old);
        giveBack(c, slotOf(c, from));
    }
    setRecord(f, offset, bits);
    return true;
}

void CardBlocks::mark(FaceId face, std::uint32_t bits)
{
    const FaceRecord& now = record(face);
    setRecord(static_cast<std::uint32_t>(face),
              now.offset,
              (now.bits & FaceRecord::kLevelMask) | (bits & ~FaceRecord::kLevelMask));
}

void CardBlocks::setRecord(std::uint32_t face, std::uint32_t offset, std::uint32_t bits)
{
    const FaceRecord made{offset, bits};
    if (m_records[face] == made) {
        return;
    }
    m_records[face] = made;
    if (!m_isChanged[face]) {
        m_isChanged[face] = true;
        m_changed.push_back(face);
    }
}

/// A slot of the class for one face, whom the caller enters; `kNone` where there is no room.
std::uint32_t CardBlocks::takeSlot(int level)
{
    Class& c = classOf(level);
    const auto taken = [&](std::uint32_t slot) {
        ++c.used;
        m_blockElements += c.size;
        return slot;
    };
    if (!c.holes.empty()) {
        const std::uint32_t slot = c.holes.back();
        c.holes.pop_back();
        return taken(slot);
    }
    if (c.faces.size() == c.shelves.size() * c.perShelf) {
        const std::uint32_t first = takePages(c.order);
        if (first == kNone) {
            return kNone;
        }
        const auto index = static_cast<std::uint32_t>(c.shelves.size());
        c.shelves.push_back(first);
        std::fill_n(m_shelfAt.begin() + first,
                    std::size_t{1} << c.order,
                    Shelf{static_cast<std::int8_t>(level), index});
    }
    c.faces.push_back(kNone);
    return taken(static_cast<std::uint32_t>(c.faces.size() - 1));
}

void CardBlocks::giveBack(Class& c, std::uint32_t slot)
{
    c.faces[slot] = kNone;
    c.holes.push_back(slot);
    --c.used;
    m_blockElements -= c.size;
}

void CardBlocks::compact(std::size_t most)
{
    for (Class& c : m_classes) {
        if (hasSpareShelf(c)) {
            compact(c, most);
        }
    }
}

/// Blocks from the end into holes that will not be at the end, then shelves that are left over go.
void CardBlocks::compact(Class& c, std::size_t& most)
{
    const std::uint32_t end = c.used; // all of them fit before it
    const auto dropEnd = [&] {
        while (!c.faces.empty() && c.faces.back() == kNone) {
            c.faces.pop_back();
        }
    };
    std::vector<std::uint32_t> left; // holes behind it
    while (most > 0 && !c.holes.empty()) {
        const std::uint32_t hole = c.holes.back();
        c.holes.pop_back();
        if (hole >= end) {
            left.push_back(hole);
            continue;
        }
        dropEnd();
        const auto last = static_cast<std::uint32_t>(c.faces.size() - 1);
        const std::uint32_t face = c.faces[last];
        m_moves.push_back({offsetOf(c, last), offsetOf(c, hole), c.size});
        c.faces[hole] = face;
        c.faces.pop_back();
        setRecord(face, offsetOf(c, hole), m_records[face].bits);
        --most;
    }
    dropEnd();
    c.holes.insert(c.holes.end(), left.begin(), left.end());
    std::erase_if(c.holes, [&](std::uint32_t slot) { return slot >= c.faces.size(); });
    while (!c.shelves.empty() && (c.shelves.size() - 1) * c.perShelf >= c.faces.size()) {
        const std::uint32_t first = c.shelves.back();
        c.shelves.pop_back();
        std::fill_n(m_shelfAt.begin() + first, std::size_t{1} << c.order, Shelf{});
        m_freePages += 1U << c.order;
        givePages(first, c.order);
    }
}

// Pages

/// A run of 2^order pages, whatever has to move for it; `kNone` where too few are free.
std::uint32_t CardBlocks::takePages(std::uint32_t order)
{
    std::uint32_t first = findPages(order);
    if (first == kNone && m_freePages < 1U << order) {
        // Shelf by shelf, no more of them than needed: each block that moves takes time.
        for (Class& c : m_classes) {
            while (m_freePages < 1U << order && hasSpareShelf(c)) {
                std::size_t most = c.perShelf;
                compact(c, most);
            }
        }
        first = findPages(order);
    }
    if (first == kNone && clearWindow(order)) {
        first = findPages(order);
    }
    if (first != kNone) {
        m_freePages -= 1U << order;
    }
    return first;
}

/// The first free run of the smallest order that is enough; what is more is given back.
std::uint32_t CardBlocks::findPages(std::uint32_t order)
{
    std::uint32_t found = order;
    while (found < kOrders && m_free[found].empty()) {
        ++found;
    }
    if (found == kOrders) {
        return kNone;
    }
    const std::uint32_t first = *m_free[found].begin();
    m_free[found].erase(m_free[found].begin());
    while (found > order) {
        --found;
        m_free[found].insert(first + (1U << found));
    }
    return first;
}

/// Joins the run with its buddies as far as they are free. Does not count them.
void CardBlocks::givePages(std::uint32_t first, std::uint32_t order)
{
    while (order + 1 < kOrders && m_free[order].erase(first ^ (1U << order)) > 0) {
        first &= ~(1U << order);
        ++order;
    }
    m_free[order].insert(first);
}

/// Makes a free run of 2^order pages by moving smaller shelves out of the emptiest one.
///
/// It works whenever as many pages are free in whole runs of that order: those outside of the run
/// are at least as many as those occupied in it, and by the same argument make room for every
/// smaller shelf.
bool CardBlocks::clearWindow(std::uint32_t order)
{
    const std::uint32_t size = 1U << order;
    std::uint32_t best = kNone;
    std::uint32_t leastUsed = size;
    std::uint32_t freePages = 0;
    for (std::uint32_t first = 0; first + size <= m_pages; first += size) {
        std::uint32_t used = 0;
        bool isKept = false;
        for (std::uint32_t page = first; page < first + size; ++page) {
            used += m_shelfAt[page].level != kFree ? 1 : 0;
            isKept = isKept || m_shelfAt[page].level == kKept;
        }
        freePages += isKept ? 0 : size - used;
        if (!isKept && used < leastUsed) {
            leastUsed = used;
            best = first;
        }
    }
    return best != kNone && freePages >= size && moveOut(best, order);
}

/// Moves every shelf out of a run of pages, which is free then.
bool CardBlocks::moveOut(std::uint32_t begin, std::uint32_t order)
{
    const std::uint32_t end = begin + (1U << order);
    // Its free pages are not for what moves out of it.
    std::vector<Run> freed;
    for (std::uint32_t k = 0; k < order; ++k) {
        const auto from = m_free[k].lower_bound(begin);
        const auto to = m_free[k].lower_bound(end);
        for (auto at = from; at != to; ++at) {
            freed.push_back({*at, k});
        }
        m_free[k].erase(from, to);
    }
    std::vector<Run> shelves;
    for (std::uint32_t page = begin; page < end;) {
        if (m_shelfAt[page].level == kFree) {
            m_shelfAt[page++].level = kKept;
        } else {
            shelves.push_back({page, classOf(m_shelfAt[page].level).order});
            page += 1U << shelves.back().order;
        }
    }
    // The largest first: once small ones have taken their places they might not fit.
    std::ranges::stable_sort(shelves, std::greater<>(), &Run::order);
    bool moved = true;
    for (const Run& shelf : shelves) {
        moved = moved && moveShelf(shelf);
        if (moved) {
            freed.push_back(shelf);
        }
    }
    for (const Run& run : freed) {
        std::fill_n(m_shelfAt.begin() + run.first, std::size_t{1} << run.order, Shelf{});
        givePages(run.first, run.order);
    }
    return moved;
}

/// To pages elsewhere; its own stay out of use.
bool CardBlocks::moveShelf(const Run& run)
{
    std::uint32_t to = findPages(run.order);
    if (to == kNone && clearWindow(run.order)) {
        to = findPages(run.order);
    }
    if (to == kNone) {
        return false;
    }
    const Shelf shelf = m_shelfAt[run.first];
    const std::size_t pages = std::size_t{1} << run.order;
    std::fill_n(m_shelfAt.begin() + to, pages, shelf);
    std::fill_n(m_shelfAt.begin() + run.first, pages, Shelf{kKept, 0});
    Class& c = classOf(shelf.level);
    c.shelves[shelf.index] = to;
    m_moves.push_back(
        {m_heapBegin + run.first * m_page, m_heapBegin + to * m_page, c.perShelf * c.size});
    const std::size_t begin = std::size_t{shelf.index} * c.perShelf;
    const std::size_t end = std::min<std::size_t>(begin + c.perShelf, c.faces.size());
    for (std::size_t slot = begin; slot < end; ++slot) {
        if (const std::uint32_t face = c.faces[slot]; face != kNone) {
            setRecord(face, offsetOf(c, static_cast<std::uint32_t>(slot)), m_records[face].bits);
        }
    }
    return true;
}

// What changed

std::vector<CardBlocks::Move> CardBlocks::takeMoves()
{
    return std::exchange(m_moves, {});
}

std::vector<std::uint32_t> CardBlocks::takeChanged()
{
    for (const std::uint32_t face : m_changed) {
        m_isChanged[face] = false;
    }
    std::ranges::sort(m_changed);
    return std::exchange(m_changed, {});
}

} // namespace trixel::render
