// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/display_texels.h"

#include "core/texture/mips.h"

#include <algorithm>
#include <utility>

namespace trixel::render {

namespace {

/// Rows of a rectangle closer than this are sent in one go: a call costs more than some texels.
constexpr std::uint32_t kMergeGap = 32;
constexpr std::size_t kMostReserved = 1U << 20U; // bytes, before it is known what there is
/// Room to spare, so that painting unpainted faces seldom needs a larger buffer.
constexpr std::uint64_t kLeastSpare = 1U << 18U;

std::uint64_t roomFor(std::uint64_t texels, std::uint64_t most)
{
    return std::min(texels + std::max(texels / 4, kLeastSpare), most);
}

std::uint32_t texelsOf(const FaceTexels& face, int drop)
{
    return face.isConstant() ? 1 : face.level().coarser(drop).texelCount();
}

std::uint64_t texelsAtDrop(const TexelStore& store, int drop)
{
    std::uint64_t count = 0;
    for (std::size_t f = 0; f < store.faceCount(); ++f) {
        count += texelsOf(store.face(faceId(f)), drop);
    }
    return count;
}

/// Adds a range, joining it to the one before where they meet.
void addRange(std::vector<DisplayUpdate::Range>& ranges, std::uint32_t first, std::uint32_t count)
{
    if (!ranges.empty() && ranges.back().first + ranges.back().count == first) {
        ranges.back().count += count;
    } else {
        ranges.push_back({first, count});
    }
}

} // namespace

void DisplayTexels::reset(const TexelStore& store, int mipDrop, std::uint32_t maxTexels)
{
    m_format = displayFormat(store.format().type);
    m_channels = usualChannels(store.format());
    m_dropAsked = mipDrop;
    m_maxTexels = maxTexels;
    layOut(store);
}

void DisplayTexels::layOut(const TexelStore& store)
{
    m_drop = m_dropAsked;
    std::uint64_t needed = texelsAtDrop(store, m_drop);
    while (needed > m_maxTexels && m_drop < Level::kMax) {
        needed = texelsAtDrop(store, ++m_drop);
    }
    m_capacity = static_cast<std::uint32_t>(roomFor(needed, m_maxTexels));
    m_used = 0;
    m_nextFace = 0;
    m_fresh = true;
    m_touched.clear();
    m_records.assign(store.faceCount(), FaceRecord{});
}

/// Gives the face a range that fits its texels, a new one if its present one does not.
/// \return  false when there is no room for it in the largest buffer
bool DisplayTexels::place(const TexelStore& store, FaceId face)
{
    const FaceTexels& texels = store.face(face);
    const int level = texels.level().coarser(m_drop).log2();
    FaceRecord& record = m_records[indexOf(face)];
    const bool fits = !record.isPending() && record.level() == level &&
                      (!record.isConstant() || texels.isConstant());
    if (fits) {
        return true;
    }
    const std::uint64_t end = std::uint64_t{m_used} + texelsOf(texels, m_drop);
    if (end > m_maxTexels) {
        return false;
    }
    if (end > m_capacity) {
        m_capacity = static_cast<std::uint32_t>(roomFor(end, m_maxTexels));
    }
    record.offset = m_used;
    record.bits =
        static_cast<std::uint32_t>(level) | (texels.isConstant() ? FaceRecord::kConstant : 0);
    m_used = static_cast<std::uint32_t>(end);
    return true;
}

void DisplayTexels::touch(const TexelStore& store, std::span<const TouchedRect> rects)
{
    for (const TouchedRect& touched : rects) {
        if (indexOf(touched.face) >= m_nextFace) {
            continue; // will be sent as it is then
        }
        const FaceRecord before = m_records[indexOf(touched.face)];
        if (!place(store, touched.face)) {
            layOut(store); // ranges given up since the last time may make enough room
            return;
        }
        const bool moved = before != m_records[indexOf(touched.face)];
        const Rect rect{touched.x,
                        touched.y,
                        std::uint32_t{touched.x} + touched.width,
                        std::uint32_t{touched.y} + touched.height,
                        moved || touched.wholeFace || m_drop > 0,
                        moved};
        const auto [at, isNew] =
            m_touched.try_emplace(static_cast<std::uint32_t>(touched.face), rect);
        if (!isNew) {
            Rect& known = at->second;
            known = {std::min(known.x0, rect.x0),
                     std::min(known.y0, rect.y0),
                     std::max(known.x1, rect.x1),
                     std::max(known.y1, rect.y1),
                     known.whole || rect.whole,
                     known.moved || rect.moved};
        }
    }
}

void DisplayTexels::touchAll()
{
    m_nextFace = 0;
    m_touched.clear();
}

void DisplayTexels::showChannels(const CardChannels& channels)
{
    if (channels != m_channels) {
        m_channels = channels;
        touchAll();
    }
}

bool DisplayTexels::hasWork() const
{
    return m_fresh || !m_touched.empty() || m_nextFace < m_records.size();
}

DisplayUpdate DisplayTexels::take(const TexelStore& store, std::size_t byteBudget)
{
    DisplayUpdate update;
    update.bytes.reserve(std::min(byteBudget, kMostReserved));
    update.fresh = std::exchange(m_fresh, false);
    emitTouched(store, update);
    emitPending(store, byteBudget, update);
    update.fresh = update.fresh || std::exchange(m_fresh, false);
    update.capacity = m_capacity;
    return update;
}

void DisplayTexels::emitTouched(const TexelStore& store, DisplayUpdate& update)
{
    std::vector<std::uint32_t> faces;
    faces.reserve(m_touched.size());
    for (const auto& [face, rect] : m_touched) {
        faces.push_back(face);
    }
    // In the order of the buffer neighbouring ranges join.
    std::ranges::sort(faces, {}, [&](std::uint32_t face) { return m_records[face].offset; });
    for (const std::uint32_t face : faces) {
        const Rect& rect = m_touched.at(face);
        if (rect.whole || store.face(faceId(face)).isConstant()) {
            emitFace(store, faceId(face), update);
        } else {
            emitRect(store, faceId(face), rect, update);
        }
    }
    std::ranges::sort(faces);
    for (const std::uint32_t face : faces) {
        if (m_touched.at(face).moved) {
            addRange(update.records, face, 1);
        }
    }
    m_touched.clear();
}

void DisplayTexels::emitPending(const TexelStore& store,
                                std::size_t byteBudget,
                                DisplayUpdate& update)
{
    const std::size_t first = m_nextFace;
    while (m_nextFace < m_records.size() &&
           (m_nextFace == first || update.bytes.size() < byteBudget)) {
        if (!place(store, faceId(m_nextFace))) {
            // The store has grown since the layout was made: once more, with what it holds now.
            update = {};
            layOut(store);
            return;
        }
        emitFace(store, faceId(m_nextFace), update);
        ++m_nextFace;
    }
    if (m_nextFace > first) {
        addRange(update.records,
                 static_cast<std::uint32_t>(first),
                 static_cast<std::uint32_t>(m_nextFace - first));
    }
}

void DisplayTexels::emitFace(const TexelStore& store, FaceId face, DisplayUpdate& update) const
{
    const FaceRecord& record = m_records[indexOf(face)];
    FaceTexels texels = store.face(face);
    if (m_drop > 0 && !texels.isConstant()) {
        texels = reduced(store.format(), texels, m_drop);
    }
    if (texels.isConstant() && !record.isConstant()) {
        (void)texels.writable(); // it was painted once and keeps its range
    }
    addRange(update.texels, record.offset, texels.isConstant() ? 1 : texels.level().texelCount());
    appendShown(store.format(), m_channels, texels.bytes(), update.bytes);
}

void DisplayTexels::emitRect(const TexelStore& store,
                             FaceId face,
                             const Rect& rect,
                             DisplayUpdate& update) const
{
    const FaceRecord& record = m_records[indexOf(face)];
    const FaceTexels& texels = store.face(face);
    const std::uint32_t resolution = texels.level().resolution();
    const std::uint32_t x1 = std::min(rect.x1, resolution);
    const std::uint32_t y1 = std::min(rect.y1, resolution);
    if (rect.x0 >= x1 || rect.y0 >= y1) {
        return;
    }
    const auto send = [&](std::uint32_t first, std::uint32_t count) {
        addRange(update.texels, record.offset + first, count);
        const std::size_t bytes = texels.texelBytes();
        appendShown(store.format(),
                    m_channels,
                    texels.bytes().subspan(first * bytes, count * bytes),
                    update.bytes);
    };
    const std::uint32_t width = x1 - rect.x0;
    if (resolution - width <= kMergeGap) {
        send(rect.x0 + rect.y0 * resolution, (y1 - rect.y0 - 1) * resolution + width);
        return;
    }
    for (std::uint32_t y = rect.y0; y < y1; ++y) {
        send(rect.x0 + y * resolution, width);
    }
}

} // namespace trixel::render
