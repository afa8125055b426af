// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/display_vertices.h"

#include "core/base/check.h"
#include "core/base/parallel.h"

#include <algorithm>
#include <mutex>
#include <utility>

namespace trixel::render {

namespace {

/// Runs closer than this are sent in one go: a call costs more than some vertices.
constexpr std::uint32_t kMergeGap = 16;
/// Of mips of faces, kept for strokes that come back and for neighbours of faces to come.
constexpr std::size_t kChainBytes = 64U << 20U;
/// Room to spare, so that painting unpainted faces seldom needs a larger buffer.
constexpr std::uint64_t kLeastSpare = 1U << 18U;
constexpr std::size_t kGrain = 256; // faces that a thread takes at a time

std::uint64_t roomFor(std::uint64_t vertices, std::uint64_t most)
{
    return std::min(vertices + std::max(vertices / 8, kLeastSpare), most);
}

std::uint32_t blockSize(const FaceRecord& record)
{
    return vertexBlockSize(Level(record.level()));
}

void addRange(std::vector<DisplayUpdate::Range>& ranges, std::uint32_t first, std::uint32_t count)
{
    if (!ranges.empty() && ranges.back().first + ranges.back().count == first) {
        ranges.back().count += count;
    } else {
        ranges.push_back({first, count});
    }
}

} // namespace

void DisplayVertices::reset(std::shared_ptr<const FilterMesh> mesh,
                            const TexelStore& store,
                            int mipDrop,
                            std::uint64_t maxVertices)
{
    check(mesh->faceCount() == store.faceCount(), "texels of this mesh");
    m_mesh = std::move(mesh);
    m_format = displayFormat(store.format().type);
    m_dropAsked = mipDrop;
    m_maxVertices = maxVertices;
    layOut(store);
}

std::uint32_t DisplayVertices::sizeOf(const TexelStore& store, FaceId face, bool isConstant) const
{
    return vertexBlockSize(isConstant ? Level(0) : store.face(face).level().coarser(m_drop));
}

void DisplayVertices::layOut(const TexelStore& store)
{
    m_chains.emplace(m_channels, kChainBytes);
    const FaceMips mips(store, *m_chains);
    const FaceVertices vertices(mips, m_mesh->adjacency(), m_mesh->rings());
    std::vector<bool> constant(store.faceCount());
    m_levels.resize(store.faceCount());
    for (std::size_t f = 0; f < store.faceCount(); ++f) {
        constant[f] = vertices.isConstant(faceId(f));
        m_levels[f] = store.face(faceId(f)).level();
    }
    const auto needed = [&] {
        std::uint64_t count = 0;
        for (std::size_t f = 0; f < store.faceCount(); ++f) {
            count += sizeOf(store, faceId(f), constant[f]);
        }
        return count;
    };
    m_drop = m_dropAsked;
    std::uint64_t count = needed();
    while (count > m_maxVertices && m_drop < Level::kMax) {
        ++m_drop;
        count = needed();
    }
    m_capacity = static_cast<std::uint32_t>(roomFor(count, m_maxVertices));
    m_used = 0;
    m_nextFace = 0;
    m_fresh = true;
    m_touched.clear();
    m_whole.clear();
    m_records.assign(store.faceCount(), FaceRecord{});
}

/// Gives the face a range that fits its vertices, a new one if its present one does not.
/// \return  false when there is no room for it in the largest buffer
bool DisplayVertices::place(const TexelStore& store, FaceId face, bool isConstant)
{
    const int level = store.face(face).level().coarser(m_drop).log2();
    FaceRecord& record = m_records[indexOf(face)];
    m_levels[indexOf(face)] = store.face(face).level();
    const int kept = isConstant && record.isConstant() ? 0 : level;
    if (!record.isPending() && record.level() == kept && (!record.isConstant() || isConstant)) {
        return true;
    }
    const std::uint64_t end = std::uint64_t{m_used} + sizeOf(store, face, isConstant);
    if (end > m_maxVertices) {
        return false;
    }
    if (end > m_capacity) {
        m_capacity = static_cast<std::uint32_t>(roomFor(end, m_maxVertices));
    }
    record.offset = m_used;
    const auto number = static_cast<std::uint32_t>(level);
    // A constant face has level 0 alone.
    record.bits = (isConstant ? FaceRecord::kConstant : number) | (number << FaceRecord::kOwnShift);
    m_used = static_cast<std::uint32_t>(end);
    return true;
}

void DisplayVertices::addAbout(FaceId face)
{
    for (std::uint8_t corner = 0; corner < 3; ++corner) {
        const VertexRings& rings = m_mesh->rings();
        for (const Corner& other : rings.corners(rings.ring({face, corner}))) {
            if (indexOf(other.face) < m_nextFace) {
                m_whole.insert(static_cast<std::uint32_t>(other.face));
            }
        }
    }
}

bool DisplayVertices::touch(const TexelStore& store, std::span<const TouchedRect> rects)
{
    m_chains->update(store, rects);
    m_spareChains.clear();
    for (const TouchedRect& rect : rects) {
        const bool sameLevel = store.face(rect.face).level() == m_levels[indexOf(rect.face)];
        if (rect.wholeFace || !sameLevel) {
            addAbout(rect.face); // of one constant, or of one level, no more
        } else {
            m_touched.push_back(rect);
        }
    }
    return true;
}

bool DisplayVertices::touchAll()
{
    m_nextFace = 0;
    m_touched.clear();
    m_whole.clear();
    m_spareChains.clear();
    if (m_chains) {
        m_chains->forget();
    }
    return true;
}

void DisplayVertices::showChannels(const CardChannels& channels)
{
    if (channels != m_channels) {
        m_channels = channels;
        touchAll();
        m_chains.emplace(channels, kChainBytes);
    }
}

bool DisplayVertices::hasWork() const
{
    return m_fresh || !m_touched.empty() || !m_whole.empty() || m_nextFace < m_records.size();
}

DisplayUpdate DisplayVertices::take(const TexelStore& store, std::size_t byteBudget)
{
    DisplayUpdate update;
    update.fresh = std::exchange(m_fresh, false);
    emitTouched(store, update);
    emitPending(store, byteBudget, update);
    update.fresh = update.fresh || std::exchange(m_fresh, false);
    update.capacity = m_capacity;
    m_chains->trim();
    return update;
}

void DisplayVertices::emitTouched(const TexelStore& store, DisplayUpdate& update)
{
    for (const std::uint32_t face : m_whole) {
        if (!emitFace(store, faceId(face), update)) {
            update = {};
            layOut(store);
            return;
        }
        addRange(update.records, face, 1);
    }
    TouchedVertices touched(m_mesh->adjacency(), m_mesh->rings(), [&](FaceId face) {
        return store.face(face).level().coarser(m_drop);
    });
    for (const TouchedRect& rect : m_touched) {
        touched.touch(store.face(rect.face).level(), rect);
    }
    m_touched.clear();
    const FaceMips mips(store, *m_chains, m_drop);
    const FaceVertices vertices(mips, m_mesh->adjacency(), m_mesh->rings());
    for (const VertexRun& run : touched.take(kMergeGap)) {
        const FaceRecord& record = m_records[indexOf(run.face)];
        const bool comes = m_whole.contains(static_cast<std::uint32_t>(run.face)) ||
                           indexOf(run.face) >= m_nextFace;
        if (!comes && !record.isConstant()) { // what is one constant is not touched
            addRange(update.texels, record.offset + run.first, run.count);
            vertices.appendRun(run, update.bytes);
        }
    }
    m_whole.clear();
}

void DisplayVertices::emitPending(const TexelStore& store,
                                  std::size_t byteBudget,
                                  DisplayUpdate& update)
{
    const std::size_t first = m_nextFace;
    const std::size_t begin = update.bytes.size();
    const std::size_t vertexBytes = texelBytes(m_format);
    std::vector<std::size_t> places; // in the bytes, of each face
    std::size_t end = begin;
    {
        const FaceMips mips(store, *m_chains, m_drop);
        const FaceVertices vertices(mips, m_mesh->adjacency(), m_mesh->rings());
        while (m_nextFace < m_records.size() && (m_nextFace == first || end < byteBudget)) {
            const FaceId face = faceId(m_nextFace);
            if (!place(store, face, vertices.isConstant(face))) {
                update = {};
                layOut(store);
                return;
            }
            const FaceRecord& record = m_records[m_nextFace];
            const std::uint32_t count = blockSize(record);
            addRange(update.texels, record.offset, count);
            places.push_back(end);
            end += count * vertexBytes;
            ++m_nextFace;
        }
    }
    if (places.empty()) {
        return;
    }
    update.bytes.resize(end);
    std::mutex mutex;
    parallelFor(places.size(), kGrain, Threads::all(), [&](std::size_t from, std::size_t to) {
        std::unique_ptr<ChainCache> chains;
        {
            const std::lock_guard lock(mutex);
            if (!m_spareChains.empty()) {
                chains = std::move(m_spareChains.back());
                m_spareChains.pop_back();
            }
        }
        if (!chains) {
            chains = std::make_unique<ChainCache>(m_channels, kChainBytes / 2);
        }
        const FaceMips mips(store, *chains, m_drop);
        const FaceVertices vertices(mips, m_mesh->adjacency(), m_mesh->rings());
        std::vector<std::byte> bytes;
        for (std::size_t k = from; k < to; ++k) {
            bytes.clear();
            append(vertices, faceId(first + k), bytes);
            std::ranges::copy(bytes, update.bytes.begin() + static_cast<std::ptrdiff_t>(places[k]));
            chains->trim();
        }
        const std::lock_guard lock(mutex);
        m_spareChains.push_back(std::move(chains));
    });
    if (m_nextFace == m_records.size()) {
        m_spareChains.clear(); // the texels they know may change from now on
    }
    addRange(update.records,
             static_cast<std::uint32_t>(first),
             static_cast<std::uint32_t>(m_nextFace - first));
}

void DisplayVertices::append(const FaceVertices& vertices,
                             FaceId face,
                             std::vector<std::byte>& bytes) const
{
    const FaceRecord& record = m_records[indexOf(face)];
    vertices.appendBlock(face, Level(record.level()), bytes);
}

/// Places a face and adds its vertices. \return  false when there is no room for it
bool DisplayVertices::emitFace(const TexelStore& store, FaceId face, DisplayUpdate& update)
{
    const FaceMips mips(store, *m_chains, m_drop);
    const FaceVertices vertices(mips, m_mesh->adjacency(), m_mesh->rings());
    if (!place(store, face, vertices.isConstant(face))) {
        return false;
    }
    const FaceRecord& record = m_records[indexOf(face)];
    addRange(update.texels, record.offset, blockSize(record));
    append(vertices, face, update.bytes);
    return true;
}

} // namespace trixel::render
