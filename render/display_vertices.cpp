// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/display_vertices.h"

#include "core/base/check.h"
#include "core/texture/touched_vertices.h"

#include <algorithm>
#include <utility>

namespace trixel::render {

namespace {

/// Runs closer than this are sent in one go: a call costs more than some vertices.
constexpr std::uint32_t kMergeGap = 16;
/// Of mips of faces, kept for strokes that come back.
constexpr std::size_t kChainBytes = 64U << 20U;
/// Texels read at once for what one face changes; more is a job.
constexpr std::size_t kMostRead = 1U << 22U;
/// Blocks up to here are made at once.
constexpr int kFewLevels = 6;

} // namespace

void DisplayVertices::reset(std::shared_ptr<const FilterMesh> mesh,
                            const TexelStore& store,
                            int mipDrop,
                            std::uint32_t maxVertices)
{
    check(mesh->faceCount() == store.faceCount(), "texels of this mesh");
    m_mesh = std::move(mesh);
    begin(store, mipDrop, maxVertices);
}

DisplayVertices::Opener DisplayVertices::opener() const
{
    return [form = m_form, mesh = m_mesh, prepare = preparer()](const TexelStore& store) {
        return prepare(openVertices(store, form, *mesh, Threads::all()));
    };
}

DisplayVertices::Maker DisplayVertices::maker() const
{
    return [form = m_form, mesh = m_mesh, chains = std::make_shared<SharedChains>(m_form.channels)](
               const TexelStore& store, std::span<const BlockJob> jobs) {
        return makeVertexBlocks(store, form, *mesh, jobs, *chains);
    };
}

CardOpening DisplayVertices::openNow(const TexelStore& store) const
{
    return openVertices(store, m_form, *m_mesh, Threads::all());
}

/// With a face whose vertices depend on a face's texels, itself among them; some come repeatedly.
template <class Visit>
void DisplayVertices::forFacesAbout(FaceId face, Visit visit) const
{
    const VertexRings& rings = m_mesh->rings();
    for (std::uint8_t corner = 0; corner < 3; ++corner) {
        for (const Corner& other : rings.corners(rings.ring({face, corner}))) {
            visit(other.face);
        }
    }
}

/// Of texels as they are shown, none of them from before the latest opening.
ChainCache& DisplayVertices::chains()
{
    if (!m_chains || m_chainsOpening != openingNumber()) {
        m_chains.emplace(m_form.channels, kChainBytes);
        m_chainsOpening = openingNumber();
    }
    return *m_chains;
}

void DisplayVertices::touch(const TexelStore& store, std::span<const TouchedRect> rects)
{
    DisplayBlocks::touch(store, rects);
    chains().update(store, rects);
}

void DisplayVertices::touched(FaceId face)
{
    forFacesAbout(face, [&](FaceId about) { touchInFlight(about); });
}

/// Texels that are read for what a face changes, but for those that are kept.
std::size_t DisplayVertices::costOf(const TexelStore& store, FaceId face) const
{
    std::size_t texels = 0;
    forFacesAbout(face, [&](FaceId about) {
        const FaceTexels& read = store.face(about);
        texels += read.isConstant() || m_chains->holds(about) ? 1 : read.level().texelCount();
    });
    return texels;
}

DisplayVertices::Work DisplayVertices::takeTouched(const TexelStore& store, std::size_t mostRead)
{
    Work work;
    std::vector<std::uint32_t> faces;
    faces.reserve(m_touched.size());
    for (const auto& [face, rect] : m_touched) {
        faces.push_back(face);
    }
    std::ranges::sort(faces);
    std::size_t read = 0;
    for (const std::uint32_t number : faces) {
        if (read > mostRead) {
            break;
        }
        const FaceId face = faceId(number);
        const auto at = m_touched.find(number);
        const Rect rect = at->second;
        m_touched.erase(at);
        forFacesAbout(face, [&](FaceId about) { outdateBase(about); });
        const FaceRecord& record = m_blocks.record(face);
        const bool isOther = rect.whole || record.isConstant() ||
                             record.ownLevel() != m_form.shownLevel(store.face(face)).log2();
        const std::size_t cost = costOf(store, face);
        if (isOther || cost > kMostRead) {
            std::unordered_set<std::uint32_t>& to = isOther ? work.whole : work.later;
            forFacesAbout(face,
                          [&](FaceId about) { to.insert(static_cast<std::uint32_t>(about)); });
        } else {
            work.parts.push_back(rect.of(face));
        }
        read += std::min(cost, kMostRead);
    }
    return work;
}

void DisplayVertices::sendTouched(const TexelStore& store, std::size_t mostRead)
{
    if (m_touched.empty()) {
        return;
    }
    (void)chains();
    const Work work = takeTouched(store, mostRead);
    {
        const FaceMips mips(store, *m_chains, m_form.mipDrop);
        const FaceVertices vertices(mips, m_mesh->adjacency(), m_mesh->rings());
        for (const std::uint32_t face : work.whole) {
            sendWhole(vertices, faceId(face));
        }
        sendParts(store, vertices, work);
    }
    for (const std::uint32_t face : work.later) {
        sendLater(faceId(face));
    }
    m_chains->trim();
}

void DisplayVertices::sendWhole(const FaceVertices& vertices, FaceId face)
{
    const bool isConstant = vertices.isConstant(face);
    show(face, vertices.level(face).log2(), isConstant);
    const int level = isConstant ? 0 : wantedLevel(face);
    if (level == 0) {
        release(face, false);
    } else if (level > kFewLevels) {
        sendLater(face);
        makeAgainLater({face, static_cast<std::uint8_t>(level)});
        return;
    } else {
        (void)place(face, level); // or its base
    }
    append(vertices, face, Level(onCard(face).level()));
}

/// The whole of a face's block.
void DisplayVertices::append(const FaceVertices& vertices, FaceId face, Level level)
{
    const std::size_t before = m_bytes.size();
    m_chains->readAt(level);
    vertices.appendBlock(face, level, m_bytes);
    write(face, static_cast<std::uint8_t>(level.log2()), 0, before);
}

/// The vertices that depend on touched texels, as far as they are on the card.
void DisplayVertices::sendParts(const TexelStore& store,
                                const FaceVertices& vertices,
                                const Work& work)
{
    TouchedVertices touched(m_mesh->adjacency(), m_mesh->rings(), [&](FaceId face) {
        return m_form.shownLevel(store.face(face));
    });
    for (const TouchedRect& rect : work.parts) {
        touched.touch(store.face(rect.face).level(), rect);
    }
    for (const VertexRun& run : touched.take(kMergeGap)) {
        const FaceRecord& record = m_blocks.record(run.face);
        const Level level(record.level());
        const std::uint32_t end =
            std::min(run.first + run.count, elementsOf(BlockKind::Vertices, level));
        const bool isSent = record.isConstant() || // and so has nothing that was touched
                            work.whole.contains(static_cast<std::uint32_t>(run.face));
        if (run.first < end && !isSent) {
            const std::size_t before = m_bytes.size();
            m_chains->readAt(level);
            vertices.appendRun({run.face, run.first, end - run.first}, m_bytes);
            write(run.face, static_cast<std::uint8_t>(record.level()), run.first, before);
        }
    }
}

/// What is there stays until a job has made it anew.
void DisplayVertices::sendLater(FaceId face)
{
    FaceOnCard& shown = onCard(face);
    if (shown.level() == 0) {
        meanLater(face);
    } else if (!shown.isStale()) { // else a job comes already
        shown.shown |= FaceOnCard::kStale;
        makeAgainLater({face, static_cast<std::uint8_t>(shown.level())});
    }
}

} // namespace trixel::render
