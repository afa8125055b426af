// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/texture/stored_faces.h"

#include "core/base/check.h"

#include <algorithm>
#include <cstring>
#include <iterator>
#include <utility>

namespace trixel {

namespace {

/// Checks along an edge of a placeholder.
constexpr std::uint32_t kChecks = 8;

std::uint32_t key(FaceId face)
{
    return static_cast<std::uint32_t>(face);
}

} // namespace

StoredFaces::StoredFaces(const TexelFormat& format,
                         std::unique_ptr<const FaceReader> reader,
                         std::uint64_t budget)
    : m_format(format)
    , m_reader(std::move(reader))
    , m_budget(budget)
{
    check(m_reader != nullptr, "a reader of faces");
}

std::shared_ptr<StoredFaces> StoredFaces::make(const TexelFormat& format,
                                               std::unique_ptr<const FaceReader> reader,
                                               std::uint64_t budget)
{
    return std::shared_ptr<StoredFaces>(new StoredFaces(format, std::move(reader), budget));
}

FaceTexels StoredFaces::face(FaceId face, Level level)
{
    return FaceTexels::stored(std::make_shared<StoredFace>(shared_from_this(), face, level),
                              level,
                              m_format.texelBytes());
}

std::uint64_t StoredFaces::cachedBytes() const
{
    const std::scoped_lock lock(m_cacheMutex);
    return m_cachedBytes;
}

StoredFaces::Words StoredFaces::texels(const StoredFace& record)
{
    // The cache before the record: texels that come to be held leave the cache after that.
    const auto found = [&] {
        Words words = fromCache(record.m_face);
        return words || !record.isHeld() ? words : record.m_words;
    };
    if (Words words = found()) {
        return words;
    }
    const std::scoped_lock lock(m_reading[key(record.m_face) % m_reading.size()]);
    if (Words words = found()) { // another thread was reading it
        return words;
    }
    Words words = read(record.m_face, record.m_level);
    cache(record.m_face, words, byteCount(record.m_level));
    return words;
}

StoredFaces::Words StoredFaces::read(FaceId face, Level level)
{
    const std::size_t bytes = byteCount(level);
    Words words = std::make_shared_for_overwrite<std::uint64_t[]>((bytes + 7) / 8);
    const std::span<std::byte> texels =
        std::as_writable_bytes(std::span(words.get(), (bytes + 7) / 8));
    if (!isDamaged(face)) {
        const Result<bool> found = m_reader->read(face, level, texels.first(bytes));
        if (found && *found) {
            m_readBytes += bytes;
            return words;
        }
        note(face,
             found ? "Face " + std::to_string(key(face)) + " lacks its texels."
                   : found.error().message);
    }
    fillWithChecks(level, texels.first(bytes));
    return words;
}

StoredFaces::Words StoredFaces::fromCache(FaceId face)
{
    const std::scoped_lock lock(m_cacheMutex);
    const auto found = m_cached.find(key(face));
    if (found == m_cached.end()) {
        return nullptr;
    }
    m_order.splice(m_order.begin(), m_order, found->second);
    return found->second->words;
}

void StoredFaces::dropFromCache(FaceId face)
{
    const std::scoped_lock lock(m_cacheMutex);
    const auto found = m_cached.find(key(face));
    if (found != m_cached.end()) {
        m_cachedBytes -= found->second->bytes;
        m_order.erase(found->second);
        m_cached.erase(found);
    }
}

void StoredFaces::cache(FaceId face, const Words& words, std::uint64_t bytes)
{
    if (bytes > m_budget) {
        return;
    }
    Order dropped; // freed when nobody waits any more
    const std::scoped_lock lock(m_cacheMutex);
    if (m_cached.contains(key(face))) { // another record of the face was read meanwhile
        return;
    }
    m_order.push_front({face, words, bytes});
    m_cached[key(face)] = m_order.begin();
    m_cachedBytes += bytes;
    while (m_cachedBytes > m_budget) {
        m_cachedBytes -= m_order.back().bytes;
        m_cached.erase(key(m_order.back().face));
        dropped.splice(dropped.begin(), m_order, std::prev(m_order.end()));
    }
}

void StoredFaces::note(FaceId face, std::string sentence)
{
    const std::scoped_lock lock(m_faultMutex);
    if (m_faultOf.emplace(key(face), m_faults.size()).second) {
        m_faults.push_back({face, std::move(sentence)});
        m_faultCount = m_faults.size();
    }
}

std::vector<FaceFault> StoredFaces::faults(std::size_t from) const
{
    const std::scoped_lock lock(m_faultMutex);
    const std::size_t first = std::min(from, m_faults.size());
    return {m_faults.begin() + static_cast<std::ptrdiff_t>(first), m_faults.end()};
}

bool StoredFaces::isDamaged(FaceId face) const
{
    if (m_faultCount == 0) {
        return false;
    }
    const std::scoped_lock lock(m_faultMutex);
    return m_faultOf.contains(key(face));
}

// Full in the first and third channel beside nothing at all: what no texture looks like by chance.
void StoredFaces::fillWithChecks(Level level, std::span<std::byte> texels) const
{
    std::vector<float> one(m_format.channels, 1.0F);
    std::vector<float> other(m_format.channels, 0.0F);
    if (m_format.channels > 1) {
        one[1] = 0;
    }
    if (m_format.alpha) {
        one[*m_format.alpha] = other[*m_format.alpha] = 1;
    }
    const std::size_t size = m_format.texelBytes();
    std::vector<std::byte> stored(2 * size);
    encode(m_format.type, one, std::span(stored).first(size));
    encode(m_format.type, other, std::span(stored).last(size));
    const std::uint32_t resolution = level.resolution();
    const std::uint32_t side = std::max(1U, resolution / kChecks);
    std::byte* to = texels.data();
    for (std::uint32_t y = 0; y < resolution; ++y) {
        for (std::uint32_t x = 0; x < resolution; ++x, to += size) {
            std::memcpy(to, stored.data() + ((x / side + y / side) % 2) * size, size);
        }
    }
}

StoredFace::StoredFace(std::shared_ptr<StoredFaces> faces, FaceId face, Level level)
    : m_faces(std::move(faces))
    , m_face(face)
    , m_level(level)
{
}

StoredFace::~StoredFace()
{
    if (m_words) {
        m_faces->m_heldBytes -= m_faces->byteCount(m_level);
    }
}

const std::byte* StoredFace::hold()
{
    if (const std::byte* ready = m_ready.load(std::memory_order_acquire)) {
        return ready;
    }
    std::call_once(m_once, [this] {
        m_words = m_faces->texels(*this);
        m_faces->m_heldBytes += m_faces->byteCount(m_level);
        m_ready.store(reinterpret_cast<const std::byte*>(m_words.get()), std::memory_order_release);
        m_faces->dropFromCache(m_face); // not to be counted twice
    });
    return m_ready.load(std::memory_order_acquire);
}

std::shared_ptr<std::uint64_t[]> StoredFace::pin()
{
    return isHeld() ? m_words : m_faces->texels(*this);
}

std::optional<FaceTexels> StoredFace::coarser(Level level) const
{
    const TexelFormat& format = m_faces->format();
    std::vector<std::byte> texels(m_faces->byteCount(level));
    const Result<bool> found = m_faces->m_reader->read(m_face, level, texels);
    if (!found || !*found) {
        return std::nullopt;
    }
    return FaceTexels::full(level, format.texelBytes(), texels);
}

} // namespace trixel
