// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/display_blocks.h"

#include "core/base/check.h"

#include <algorithm>
#include <utility>

namespace trixel::render {

namespace {

/// Room to spare, so that painting unpainted faces seldom needs a larger buffer.
constexpr std::uint64_t kLeastSpare = 1U << 18U;
/// Jobs are made in parts when they are made at once.
constexpr std::size_t kPartBytes = 1U << 22U;
/// Records closer than this are sent in one go: a call costs more than some records.
constexpr std::uint32_t kRecordGap = 64;
/// Rectangles beyond which everything is taken to be touched.
constexpr std::size_t kManyRects = 1U << 16U;
/// Faces whose bases are sent at once.
constexpr std::size_t kBasesAtOnce = 1U << 16U;
/// Blocks moved in one frame.
constexpr std::size_t kMovesAtOnce = 256;

/// Adds a range, joining it to the one before where they meet.
void addRange(std::vector<DisplayUpdate::Range>& ranges,
              std::uint32_t first,
              std::uint32_t count,
              std::uint32_t gap = 0)
{
    if (!ranges.empty()) {
        DisplayUpdate::Range& last = ranges.back();
        const std::uint32_t end = last.first + last.count;
        if (first >= end && first - end <= gap) {
            last.count = first + count - last.first;
            return;
        }
    }
    ranges.push_back({first, count});
}

DisplayUpdate joined(DisplayUpdate first, DisplayUpdate second)
{
    const auto append = [](auto& to, const auto& from) {
        to.insert(to.end(), from.begin(), from.end());
    };
    second.fresh = first.fresh;
    append(first.moves, second.moves);
    append(first.texels, second.texels);
    append(first.bytes, second.bytes);
    append(first.records, second.records);
    second.moves = std::move(first.moves);
    second.texels = std::move(first.texels);
    second.bytes = std::move(first.bytes);
    second.records = std::move(first.records);
    return second;
}

MadeBlocks makeOnAllCores(const DisplayBlocks::Maker& make,
                          const TexelStore& store,
                          std::span<const BlockJob> jobs)
{
    constexpr std::size_t kGrain = 128;
    std::vector<MadeBlocks> parts((jobs.size() + kGrain - 1) / kGrain);
    parallelFor(jobs.size(), kGrain, Threads::all(), [&](std::size_t begin, std::size_t end) {
        parts[begin / kGrain] = make(store, jobs.subspan(begin, end - begin));
    });
    MadeBlocks made;
    for (const MadeBlocks& part : parts) {
        for (const std::size_t end : part.ends) {
            made.ends.push_back(made.bytes.size() + end);
        }
        made.jobs.insert(made.jobs.end(), part.jobs.begin(), part.jobs.end());
        made.bytes.insert(made.bytes.end(), part.bytes.begin(), part.bytes.end());
    }
    return made;
}

} // namespace

void DisplayBlocks::begin(const TexelStore& store, int mipDrop, std::uint32_t maxElements)
{
    const bool isSame = m_isOpen && m_faces.size() == store.faceCount() &&
                        format() == displayFormat(store.format().type);
    m_isOpen = isSame;
    m_isShown = m_isShown && isSame;
    m_form = CardForm::of(store, mipDrop);
    setMost(maxElements);
    m_opening.reset();
    opensAnew();
    m_touched.clear();
}

void DisplayBlocks::setMost(std::uint32_t maxElements)
{
    if (maxElements == m_maxElements) {
        return;
    }
    m_maxElements = maxElements;
    if (m_opening && m_opening->isFresh) { // into a buffer of another size
        m_opening.reset();
        opensAnew();
    }
    if (m_isOpen && m_blocks.capacity() > std::max(maxElements, m_blocks.baseElements())) {
        m_isOpen = false; // a smaller buffer
        m_opening.reset();
        opensAnew();
    }
    m_plans = m_isOpen;
}

void DisplayBlocks::showChannels(const CardChannels& channels)
{
    if (channels != m_form.channels) {
        m_form.channels = channels;
        if (m_isOpen || m_opens) {
            opensAnew();
        }
    }
}

void DisplayBlocks::show(FaceId face, int own, bool isConstant)
{
    m_faces[indexOf(face)].own = static_cast<std::uint8_t>(isConstant ? 0 : own);
    m_blocks.mark(face, FaceRecord::bitsOf(own, isConstant));
}

CardRoom DisplayBlocks::mostRoom() const
{
    const std::uint64_t front = m_blocks.capacity() - m_blocks.heapElements();
    return CardRoom::of(m_blocks, m_maxElements > front ? m_maxElements - front : 0);
}

void DisplayBlocks::planEverything()
{
    std::vector<Wish> wishes(m_faces.size());
    for (std::size_t f = 0; f < wishes.size(); ++f) {
        wishes[f] = static_cast<Wish>(8 * m_blocks.record(faceId(f)).ownLevel());
    }
    ResidencyPlan plan = planResidency(wishes, m_faces, mostRoom());
    follow(std::move(plan));
    m_followsView = false;
}

void DisplayBlocks::follow(ResidencyPlan plan)
{
    check(plan.wanted.size() == m_faces.size(), "a plan for these faces");
    m_plan = std::move(plan);
    m_nextMake = 0;
    m_nextSpare = 0;
    m_plans = false;
    m_followsView = true;
    for (const FaceId face : m_plan.release) {
        release(face, false);
    }
    makeRoomFor(m_plan.elements);
}

/// A larger buffer, where blocks need it and it may be.
void DisplayBlocks::makeRoomFor(std::uint64_t blockElements)
{
    if (blockElements <= m_room.elements || m_blocks.capacity() >= m_maxElements) {
        return;
    }
    const std::uint64_t wanted =
        m_blocks.capacity() + 2 * (blockElements - m_room.elements) + kLeastSpare;
    const std::uint64_t grown = std::max(wanted, m_blocks.capacity() + m_blocks.capacity() / 2UL);
    m_blocks.grow(static_cast<std::uint32_t>(std::min<std::uint64_t>(grown, m_maxElements)));
    m_room = CardRoom::of(m_blocks, m_blocks.heapElements());
}

bool DisplayBlocks::hasReady() const
{
    return m_opening || !m_touched.empty() || !m_writes.empty() || m_isMakingRoom;
}

bool DisplayBlocks::hasWork() const
{
    return m_opens || hasReady() || hasJobs() || (m_plans && !m_followsView);
}

DisplayUpdate DisplayBlocks::take(const TexelStore& store, std::size_t byteBudget)
{
    if (m_opens && !m_opening) {
        open(preparer()(openNow(store)));
    }
    std::optional<DisplayUpdate> bases;
    if (m_opening) {
        bases = nextBases(m_faces.size());
    }
    if (!m_isOpen) {
        return {};
    }
    sendTouched(store, ~std::size_t{0});
    if (m_plans && !m_followsView) {
        planEverything();
    }
    const Maker make = hasJobs() ? maker() : Maker();
    while (make && m_bytes.size() < byteBudget) {
        const std::size_t left = byteBudget - std::min(byteBudget, m_bytes.size());
        const JobBatch batch = nextJobs(std::min(left, kPartBytes));
        if (batch.jobs.empty()) {
            break;
        }
        accept(makeOnAllCores(make, store, batch.jobs), batch, store);
    }
    return bases ? joined(std::move(*bases), gathered()) : gathered();
}

DisplayUpdate DisplayBlocks::takeReady(const TexelStore& store, std::size_t mostRead)
{
    if (m_opening) {
        return nextBases(kBasesAtOnce);
    }
    if (m_isOpen && !m_opens) {
        sendTouched(store, mostRead);
    }
    return gathered();
}

void DisplayBlocks::write(FaceId face,
                          std::uint8_t level,
                          std::uint32_t first,
                          std::size_t bytesBefore)
{
    const auto count =
        static_cast<std::uint32_t>((m_bytes.size() - bytesBefore) / m_form.elementBytes());
    m_writes.push_back({face, level, first, count});
}

/// Where they belong now, if anywhere: blocks come, go and become coarser while they wait.
std::optional<DisplayUpdate::Range> DisplayBlocks::placeOf(const Write& write) const
{
    const FaceRecord& record = m_blocks.record(write.face);
    if (isVertices()) { // a coarser block is the beginning of a finer one
        const std::uint32_t size = elementsOf(m_kind, Level(record.level()));
        const std::uint32_t end = std::min(write.first + write.count, size);
        return write.first < end ? std::optional(DisplayUpdate::Range{record.offset + write.first,
                                                                      end - write.first})
                                 : std::nullopt;
    }
    if (write.level == 0) {
        return DisplayUpdate::Range{m_blocks.baseOffset(write.face) + write.first, write.count};
    }
    const bool isThere = m_blocks.hasBlock(write.face) && record.level() == write.level;
    return isThere ? std::optional(DisplayUpdate::Range{record.offset + write.first, write.count})
                   : std::nullopt;
}

/// Everything staged, now that it is known where blocks lie.
DisplayUpdate DisplayBlocks::gathered()
{
    DisplayUpdate update;
    m_blocks.compact(kMovesAtOnce);
    m_noRoom = 0;
    m_spared = 0;
    m_isMakingRoom = false;
    update.capacity = m_blocks.capacity();
    update.moves = m_blocks.takeMoves();
    const std::size_t elementBytes = m_form.elementBytes();
    std::size_t from = 0;
    std::size_t to = 0; // behind, where something has no place any more
    for (const Write& write : m_writes) {
        if (const auto place = placeOf(write)) {
            addRange(update.texels, place->first, place->count);
            const std::size_t size = place->count * elementBytes;
            if (from != to) {
                std::copy_n(m_bytes.begin() + static_cast<std::ptrdiff_t>(from),
                            size,
                            m_bytes.begin() + static_cast<std::ptrdiff_t>(to));
            }
            to += size;
        }
        from += write.count * elementBytes;
    }
    m_bytes.resize(to);
    m_writes.clear();
    update.bytes = std::exchange(m_bytes, {});
    for (const std::uint32_t face : m_blocks.takeChanged()) {
        addRange(update.records, face, 1, kRecordGap);
    }
    return update;
}

// What was touched

TouchedRect DisplayBlocks::Rect::of(FaceId face) const
{
    const auto size = [](std::uint32_t from, std::uint32_t to) {
        return static_cast<std::uint16_t>(to - from);
    };
    return {face,
            static_cast<std::uint16_t>(x0),
            static_cast<std::uint16_t>(y0),
            size(x0, x1),
            size(y0, y1),
            whole};
}

void DisplayBlocks::touch(const TexelStore& /*store*/, std::span<const TouchedRect> rects)
{
    if (rects.size() > kManyRects) {
        touchAll();
        return;
    }
    for (const TouchedRect& rect : rects) {
        const Rect added{rect.x,
                         rect.y,
                         std::uint32_t{rect.x} + rect.width,
                         std::uint32_t{rect.y} + rect.height,
                         rect.wholeFace};
        const auto [at, isNew] =
            m_touched.try_emplace(static_cast<std::uint32_t>(rect.face), added);
        if (!isNew) {
            Rect& known = at->second;
            known = {std::min(known.x0, added.x0),
                     std::min(known.y0, added.y0),
                     std::max(known.x1, added.x1),
                     std::max(known.y1, added.y1),
                     known.whole || added.whole};
        }
        if (m_isOpen) {
            touched(rect.face);
        }
    }
}

void DisplayBlocks::touchInFlight(FaceId face)
{
    std::uint8_t& inFlight = m_inFlight[indexOf(face)];
    inFlight |= inFlight != 0 ? kTouchedInFlight : 0;
}

int DisplayBlocks::wantedLevel(FaceId face)
{
    const FaceOnCard& shown = m_faces[indexOf(face)];
    std::uint8_t& wanted = m_plan.wanted[indexOf(face)];
    if (!m_followsView) {
        wanted = static_cast<std::uint8_t>(std::max<int>(wanted, shown.own - m_plan.bias / 8));
    }
    return std::min<int>(wanted, shown.own);
}

bool DisplayBlocks::place(FaceId face, int level)
{
    bool hasRoom = resize(face, level);
    if (!hasRoom && m_blocks.capacity() < m_maxElements) {
        makeRoomFor(m_room.elements + m_room.perBlock[static_cast<std::size_t>(level)]);
        m_noRoom = 0;
        hasRoom = resize(face, level);
    }
    if (hasRoom) {
        m_faces[indexOf(face)].shown = static_cast<std::uint8_t>(level);
        return true;
    }
    release(face, false);
    makeAgainLater({face, static_cast<std::uint8_t>(level)});
    m_plans = true;
    return false;
}

/// A million faces that leave a view are given up without a copy: of vertices their bases are what
/// their blocks begin with, where nothing was painted since.
void DisplayBlocks::release(FaceId face, bool keeps)
{
    m_blocks.release(face, keeps && m_hasOldBase[indexOf(face)]);
    if (keeps) {
        m_hasOldBase[indexOf(face)] = false;
    }
    m_faces[indexOf(face)].shown = 0;
}

void DisplayBlocks::meanLater(FaceId face)
{
    if (!m_noMean[indexOf(face)]) {
        m_noMean[indexOf(face)] = true;
        m_means.push_back(face);
    }
}

} // namespace trixel::render
