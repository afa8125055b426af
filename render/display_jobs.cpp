// SPDX-License-Identifier: GPL-3.0-or-later
//
// Blocks made elsewhere: what is to be made, and what becomes of it.
#include "core/base/check.h"
#include "render/display_blocks.h"

#include <algorithm>

namespace trixel::render {

std::size_t DisplayBlocks::bytesOf(int level) const
{
    return elementsOf(m_kind, Level(level)) * m_form.elementBytes();
}

bool DisplayBlocks::hasJobs(bool means) const
{
    return !m_opens && !m_opening &&
           (!m_again.empty() || m_nextMake < m_plan.make.size() ||
            (means && m_nextMean < m_means.size()));
}

/// Whether the block would be better than what is shown.
bool DisplayBlocks::isUseful(const BlockJob& job) const
{
    const FaceOnCard& face = m_faces[indexOf(job.face)];
    const int shown = face.level();
    return job.level == 0 ||
           (job.level <= face.own && (shown < job.level || shown > face.own || face.isStale()));
}

/// Makes the next block coarser that the view can do without, or gives it up.
bool DisplayBlocks::makeSpare(JobBatch& batch)
{
    while (m_nextSpare < m_plan.spare.size()) {
        const BlockJob job = m_plan.spare[m_nextSpare++];
        FaceOnCard& face = m_faces[indexOf(job.face)];
        const int shown = face.level();
        if (shown <= job.level || m_inFlight[indexOf(job.face)] != 0) {
            continue;
        }
        ++m_spared;
        if (job.level == 0) {
            release(job.face, !face.isStale());
            return true;
        }
        if (isVertices() && !face.isStale()) { // the beginning of what is there will do
            if (resize(job.face, job.level, true)) {
                face.shown = job.level;
            } else { // no room for both of them
                release(job.face, true);
                makeAgainLater(job);
            }
            return true;
        }
        batch.jobs.push_back(job);
        batch.elements += std::int64_t{m_room.perBlock[job.level]} -
                          m_room.perBlock[static_cast<std::size_t>(shown)];
        ++m_inFlight[indexOf(job.face)];
        return true;
    }
    return false;
}

/// By blocks, each with its share of what is left over.
std::int64_t DisplayBlocks::roomUsed() const
{
    std::int64_t used = 0;
    for (int level = 1; level <= Level::kMax; ++level) {
        used += std::int64_t{m_blocks.blockCount(Level(level))} *
                m_room.perBlock[static_cast<std::size_t>(level)];
    }
    return used;
}

/// Whether as much is made coarser or moved for others as one update should hold.
bool DisplayBlocks::isUpdateFull() const
{
    constexpr std::size_t kMostSpared = 1U << 14U;
    constexpr std::size_t kMostMoves = 1U << 12U; // a millisecond where the processor draws
    return m_spared >= kMostSpared || m_blocks.moveCount() >= kMostMoves;
}

DisplayBlocks::Room DisplayBlocks::addJob(const BlockJob& job, JobBatch& batch)
{
    const auto shown = static_cast<std::size_t>(m_faces[indexOf(job.face)].level());
    const std::int64_t more =
        job.level == 0 ? 0 : std::int64_t{m_room.perBlock[job.level]} - m_room.perBlock[shown];
    const auto isTooMuch = [&] {
        return more > 0 && roomUsed() + m_elementsInFlight + batch.elements + more >
                               static_cast<std::int64_t>(m_room.elements);
    };
    while (isTooMuch()) {
        if (isUpdateFull()) {
            m_isMakingRoom = true;
            return Room::Later;
        }
        if (!makeSpare(batch)) {
            return Room::None;
        }
    }
    batch.jobs.push_back(job);
    batch.elements += more;
    ++m_inFlight[indexOf(job.face)];
    return Room::Found;
}

/// Means of faces that have none yet.
void DisplayBlocks::addMeans(std::size_t bytes, JobBatch& batch)
{
    const std::size_t most = bytes / bytesOf(0);
    for (; m_nextMean < m_means.size() && batch.jobs.size() < most; ++m_nextMean) {
        const FaceId face = m_means[m_nextMean];
        m_noMean[indexOf(face)] = false;
        (void)addJob({face, 0}, batch); // needs no room
    }
    if (m_nextMean == m_means.size()) {
        m_means.clear();
        m_nextMean = 0;
    }
}

JobBatch DisplayBlocks::nextJobs(std::size_t bytes, bool means)
{
    JobBatch batch;
    batch.generation = m_generation;
    if (m_opens || m_opening || !m_isOpen || m_isMakingRoom) {
        return batch;
    }
    constexpr std::size_t kMostJobs = 2048; // so that no batch takes long to take over
    constexpr std::size_t kMostLooks = 1U << 16U;
    std::size_t made = 0;
    std::size_t looks = 0; // most of a plan may have become needless
    const auto wantsMore = [&] {
        return (batch.jobs.empty() || (made < bytes && batch.jobs.size() < kMostJobs)) &&
               !m_isMakingRoom && looks++ < kMostLooks;
    };
    const auto tryJob = [&](const BlockJob& job) {
        if (!isUseful(job)) {
            return Room::Found;
        }
        const Room room = addJob(job, batch);
        made += room == Room::Found ? bytesOf(job.level) : 0;
        return room;
    };
    for (std::size_t left = m_again.size(); wantsMore() && left > 0; --left) {
        const BlockJob job = m_again.front();
        m_again.pop_front();
        if ((m_inFlight[indexOf(job.face)] & kTouchedInFlight) != 0) {
            m_again.push_back(job); // beside those under way it would count as touched like them
            continue;
        }
        m_isAgain.erase(keyOf(job));
        switch (tryJob(job)) {
        case Room::Found:
            break;
        case Room::None:
            m_plans = true; // there is more to show than was planned for
            break;
        case Room::Later:
            makeAgainLater(job);
            break;
        }
    }
    while (wantsMore() && m_nextMake < m_plan.make.size()) {
        const Room room = tryJob(m_plan.make[m_nextMake]);
        if (room == Room::Later) {
            break;
        }
        if (room == Room::None) {
            if (batch.jobs.empty() && m_elementsInFlight == 0) {
                m_nextMake = m_plan.make.size(); // blocks do not fit as well as was thought
            }
            m_elementsInFlight += batch.elements;
            return batch;
        }
        ++m_nextMake;
    }
    if (means && wantsMore()) {
        addMeans(std::max(bytes, bytesOf(0)), batch);
    }
    m_elementsInFlight += batch.elements;
    return batch;
}

std::optional<MadeBlocks> DisplayBlocks::makeAgain(const TexelStore& /*store*/,
                                                   const BlockJob& /*job*/) const
{
    return std::nullopt;
}

/// A job is under way no more. \return  whether its face was touched meanwhile
bool DisplayBlocks::land(const BlockJob& job)
{
    std::uint8_t& inFlight = m_inFlight[indexOf(job.face)];
    const bool wasTouched = (inFlight & kTouchedInFlight) != 0;
    inFlight = (--inFlight & ~kTouchedInFlight) == 0 ? 0 : inFlight;
    return wasTouched;
}

void DisplayBlocks::giveUp(const JobBatch& batch)
{
    if (batch.generation != m_generation) {
        return;
    }
    m_elementsInFlight -= batch.elements;
    for (const BlockJob& job : batch.jobs) {
        (void)land(job);
    }
}

void DisplayBlocks::accept(const MadeBlocks& made, const JobBatch& batch, const TexelStore& store)
{
    check(made.jobs.size() == batch.jobs.size(), "blocks of these jobs");
    if (batch.generation != m_generation) {
        return;
    }
    m_elementsInFlight -= batch.elements;
    constexpr std::size_t kMostReadAgain = 1U << 18U; // texels: a small part of a frame
    std::size_t readAgain = 0;
    std::size_t begin = 0;
    for (std::size_t k = 0; k < made.jobs.size(); ++k) {
        const BlockJob& job = made.jobs[k];
        const std::size_t end = made.ends[k];
        const auto bytes = std::span(made.bytes).subspan(begin, end - begin);
        begin = end;
        if (!land(job)) {
            acceptBlock(job, bytes);
            continue;
        }
        const auto again =
            readAgain < kMostReadAgain ? makeAgain(store, job) : std::optional<MadeBlocks>();
        if (again) {
            acceptBlock(job, again->bytes);
            readAgain += store.face(job.face).level().texelCount();
        } else {
            makeAgainLater(job);
        }
    }
}

/// What waits already is not asked for twice, however often it is touched meanwhile.
void DisplayBlocks::makeAgainLater(const BlockJob& job)
{
    if (m_isAgain.insert(keyOf(job)).second) {
        m_again.push_back(job);
    }
}

void DisplayBlocks::acceptBlock(const BlockJob& job, std::span<const std::byte> bytes)
{
    if (bytes.empty()) { // a block that the face has no more, having become of one value
        if (m_faces[indexOf(job.face)].isStale()) {
            m_touched[static_cast<std::uint32_t>(job.face)].whole = true;
        }
        return;
    }
    if (job.level > 0 && !placeBlock(job)) {
        return;
    }
    const std::size_t before = m_bytes.size();
    m_bytes.insert(m_bytes.end(), bytes.begin(), bytes.end());
    write(job.face, job.level, 0, before);
}

/// \return  false when the block is not wanted any more, or has no room
bool DisplayBlocks::placeBlock(const BlockJob& job)
{
    FaceOnCard& face = m_faces[indexOf(job.face)];
    const int wanted = std::min<int>(m_plan.wanted[indexOf(job.face)], face.own);
    const int shown = face.level();
    const bool isWrong = shown > 0 && (face.isStale() || shown > face.own);
    const bool isFiner = job.level > shown && job.level <= wanted;
    const bool isSpare = job.level < shown && job.level >= wanted;
    if (job.level > face.own || !(isWrong || isFiner || isSpare)) {
        return false;
    }
    if (resize(job.face, job.level)) {
        face.shown = job.level;
        return true;
    }
    if (isWrong) {
        release(job.face, false);
    }
    return false;
}

/// A block that found no room is not looked for again before something may have changed: each time
/// all that there is would be searched.
bool DisplayBlocks::resize(FaceId face, int level, bool keeps)
{
    const std::uint32_t bit = 1U << static_cast<unsigned>(level);
    if ((m_noRoom & bit) != 0) {
        return false;
    }
    const bool hasRoom = m_blocks.resize(face, Level(level), keeps);
    m_noRoom |= hasRoom ? 0 : bit;
    return hasRoom;
}

} // namespace trixel::render
