// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/display_texels.h"

#include "core/base/check.h"

#include <algorithm>
#include <utility>

namespace trixel::render {

namespace {

/// Texels of blocks that a buffer is made for at first; it grows where a view needs more.
constexpr std::uint64_t kUsualTexels = 1U << 24U;
/// Room to spare, so that painting unpainted faces seldom needs a larger buffer.
constexpr std::uint64_t kLeastSpare = 1U << 18U;
/// Jobs are made in parts when they are made at once.
constexpr std::size_t kPartBytes = 1U << 22U;
/// Records closer than this are sent in one go: a call costs more than some records.
constexpr std::uint32_t kRecordGap = 64;
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

} // namespace

void DisplayTexels::reset(const TexelStore& store, int mipDrop, std::uint32_t maxTexels)
{
    const bool isSame = m_isOpen && m_faces.size() == store.faceCount() &&
                        format() == displayFormat(store.format().type);
    m_isOpen = isSame;
    m_form = CardForm::of(store, mipDrop);
    setMost(maxTexels);
    opensAnew();
    m_touched.clear();
}

void DisplayTexels::setMost(std::uint32_t maxTexels)
{
    if (maxTexels == m_maxTexels) {
        return;
    }
    m_maxTexels = maxTexels;
    if (m_isOpen && m_blocks.capacity() > std::max<std::size_t>(maxTexels, m_faces.size())) {
        m_isOpen = false; // a smaller buffer
        opensAnew();
    }
    m_plans = m_isOpen;
}

void DisplayTexels::showChannels(const CardChannels& channels)
{
    if (channels != m_form.channels) {
        m_form.channels = channels;
        if (m_isOpen || m_opens) {
            opensAnew();
        }
    }
}

void DisplayTexels::opensAnew()
{
    m_opens = true;
    ++m_openingNumber;
}

void DisplayTexels::open(const CardOpening& opening)
{
    m_opens = opening.form != m_form;
    if (m_isOpen) {
        openAgain(opening);
    } else {
        openFresh(opening);
    }
    m_isOpen = true;
    m_plans = true;
    m_again.clear();
    m_writes.clear();
    m_bytes.assign(opening.bases.begin(), opening.bases.end());
    m_sendBases = true;
    m_noMean.assign(m_faces.size(), false);
    m_means.clear();
    m_nextMean = 0;
    for (std::size_t f = 0; f < m_faces.size(); ++f) {
        if ((opening.faces[f] & CardOpening::kMean) == 0) {
            meanLater(faceId(f));
        }
    }
}

void DisplayTexels::openFresh(const CardOpening& opening)
{
    const std::size_t count = opening.faces.size();
    std::uint64_t texels = 0;
    m_faces.resize(count);
    for (std::size_t f = 0; f < count; ++f) {
        const bool isConstant = (opening.faces[f] & CardOpening::kConstant) != 0;
        texels += isConstant ? 0 : Level(CardOpening::level(opening.faces[f])).texelCount();
    }
    const std::uint64_t spare = std::max(texels / 4, kLeastSpare);
    const std::uint64_t room = count + std::min(texels, kUsualTexels) + spare;
    m_blocks = CardBlocks(BlockKind::Texels,
                          count,
                          static_cast<std::uint32_t>(std::min<std::uint64_t>(room, m_maxTexels)));
    m_room = CardRoom::of(m_blocks, m_blocks.heapElements());
    for (std::size_t f = 0; f < count; ++f) {
        m_faces[f] = {};
        show(faceId(f),
             CardOpening::level(opening.faces[f]),
             (opening.faces[f] & CardOpening::kConstant) != 0);
    }
    (void)m_blocks.takeChanged(); // all records are sent
    m_fresh = true;
    ++m_generation;
    m_inFlight.assign(count, 0);
    m_elementsInFlight = 0;
    m_plan = {};
    m_plan.wanted.assign(count, m_followsView ? 0 : Level::kMax);
    m_nextMake = 0;
    m_nextSpare = 0;
}

void DisplayTexels::openAgain(const CardOpening& opening)
{
    for (std::size_t f = 0; f < m_faces.size(); ++f) {
        const bool isConstant = (opening.faces[f] & CardOpening::kConstant) != 0;
        if (isConstant) {
            m_blocks.release(faceId(f));
            m_faces[f].shown = 0;
        } else if (m_faces[f].level() > 0) {
            m_faces[f].shown |= FaceOnCard::kStale;
        }
        show(faceId(f), CardOpening::level(opening.faces[f]), isConstant);
        if (m_inFlight[f] != 0) {
            m_inFlight[f] |= kTouchedInFlight; // of what was before
        }
    }
}

/// Enters what a face is, whatever of it is on the card.
void DisplayTexels::show(FaceId face, int own, bool isConstant)
{
    m_faces[indexOf(face)].own = static_cast<std::uint8_t>(isConstant ? 0 : own);
    m_blocks.mark(face,
                  (isConstant ? FaceRecord::kConstant : 0U) | static_cast<std::uint32_t>(own)
                                                                  << FaceRecord::kOwnShift);
}

CardRoom DisplayTexels::mostRoom() const
{
    const std::uint64_t front = m_blocks.capacity() - m_blocks.heapElements();
    return CardRoom::of(m_blocks, m_maxTexels > front ? m_maxTexels - front : 0);
}

void DisplayTexels::planEverything()
{
    std::vector<Wish> wishes(m_faces.size());
    for (std::size_t f = 0; f < wishes.size(); ++f) {
        wishes[f] = static_cast<Wish>(8 * m_blocks.record(faceId(f)).ownLevel());
    }
    ResidencyPlan plan = planResidency(wishes, m_faces, mostRoom());
    follow(std::move(plan));
    m_followsView = false;
}

void DisplayTexels::follow(ResidencyPlan plan)
{
    check(plan.wanted.size() == m_faces.size(), "a plan for these faces");
    m_plan = std::move(plan);
    m_nextMake = 0;
    m_nextSpare = 0;
    m_plans = false;
    m_followsView = true;
    for (const FaceId face : m_plan.release) {
        m_blocks.release(face);
        m_faces[indexOf(face)].shown = 0;
    }
    makeRoomFor(m_plan.elements);
}

/// A larger buffer, where blocks need it and it may be.
void DisplayTexels::makeRoomFor(std::uint64_t blockElements)
{
    if (blockElements <= m_room.elements || m_blocks.capacity() >= m_maxTexels) {
        return;
    }
    const std::uint64_t wanted =
        m_blocks.capacity() + 2 * (blockElements - m_room.elements) + kLeastSpare;
    const std::uint64_t grown = std::max(wanted, m_blocks.capacity() + m_blocks.capacity() / 2UL);
    m_blocks.grow(static_cast<std::uint32_t>(std::min<std::uint64_t>(grown, m_maxTexels)));
    m_room = CardRoom::of(m_blocks, m_blocks.heapElements());
}

bool DisplayTexels::hasReady() const
{
    return m_fresh || m_sendBases || !m_touched.empty() || !m_writes.empty();
}

bool DisplayTexels::hasWork() const
{
    return m_opens || hasReady() || hasJobs() || (m_plans && !m_followsView);
}

DisplayUpdate DisplayTexels::take(const TexelStore& store, std::size_t byteBudget)
{
    if (m_opens) {
        open(openCard(store, m_form, true, Threads::all()));
    }
    if (!m_isOpen) {
        return {};
    }
    sendTouched(store, ~std::size_t{0});
    if (m_plans && !m_followsView) {
        planEverything();
    }
    while (m_bytes.size() < byteBudget) {
        const std::size_t left = byteBudget - std::min(byteBudget, m_bytes.size());
        const JobBatch batch = nextJobs(std::min(left, kPartBytes));
        if (batch.jobs.empty()) {
            break;
        }
        accept(makeBlocks(store, m_form, batch.jobs), batch, store);
    }
    return gathered();
}

DisplayUpdate DisplayTexels::takeReady(const TexelStore& store, std::size_t mostRead)
{
    if (m_isOpen && !m_opens) {
        sendTouched(store, mostRead);
    }
    return gathered();
}

/// Notes the bytes appended since as elements of a face's block. \param first  in the block
void DisplayTexels::write(FaceId face,
                          std::uint8_t level,
                          std::uint32_t first,
                          std::size_t bytesBefore)
{
    const auto count =
        static_cast<std::uint32_t>((m_bytes.size() - bytesBefore) / m_form.elementBytes());
    m_writes.push_back({face, level, first, count});
}

/// Everything staged, now that it is known where blocks lie.
DisplayUpdate DisplayTexels::gathered()
{
    DisplayUpdate update;
    m_blocks.compact(kMovesAtOnce);
    m_noRoom = 0;
    update.fresh = std::exchange(m_fresh, false);
    update.capacity = m_blocks.capacity();
    update.moves = m_blocks.takeMoves();
    if (std::exchange(m_sendBases, false)) {
        addRange(update.texels, 0, static_cast<std::uint32_t>(m_faces.size()));
    }
    std::size_t dropped = 0; // bytes of blocks that are there no more
    std::size_t at = update.texels.empty() ? 0 : m_faces.size() * m_form.elementBytes();
    for (const Write& write : m_writes) {
        const std::size_t size = write.count * m_form.elementBytes();
        const FaceRecord& record = m_blocks.record(write.face);
        if (write.level == 0) {
            addRange(update.texels, m_blocks.baseOffset(write.face) + write.first, write.count);
        } else if (m_blocks.hasBlock(write.face) && record.level() == write.level) {
            addRange(update.texels, record.offset + write.first, write.count);
        } else {
            dropped += size;
            at += size;
            continue;
        }
        if (dropped > 0) {
            std::copy_n(m_bytes.begin() + static_cast<std::ptrdiff_t>(at),
                        size,
                        m_bytes.begin() + static_cast<std::ptrdiff_t>(at - dropped));
        }
        at += size;
    }
    m_bytes.resize(m_bytes.size() - dropped);
    m_writes.clear();
    update.bytes = std::exchange(m_bytes, {});
    for (const std::uint32_t face : m_blocks.takeChanged()) {
        addRange(update.records, face, 1, kRecordGap);
    }
    return update;
}

} // namespace trixel::render
