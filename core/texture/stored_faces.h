// SPDX-License-Identifier: GPL-3.0-or-later
//
// Faces whose texels stay in a file until somebody asks for them.
//
// How it works. A `FaceTexels` may be *stored*: it knows its level and its mean, and reads its
// texels when first asked. Three ways of asking differ in how long the memory is kept:
//  * `bytes` (and all that builds on it) reads once and holds the texels in the face's own record,
//    which its copies share. Spans stay valid as long as that `FaceTexels` or a copy of it lives,
//    which is what holds for texels in memory too: no reader need know that a face was stored.
//  * `pinned` gives a face in memory and holds nothing itself; a cache keeps what was read last
//    within a budget. Whatever walks over many faces asks this way, so that its memory is bounded.
//  * `mean` and `storedLevel` answer with what the file keeps of coarser levels: a first picture
//    that reads no texels of the face's own level.
// `TexelStore::releaseHeld` gives back what `bytes` holds. It is a change of the store like any
// other: snapshots taken before keep theirs, so no thread loses what it looks at.
//
// Texels that are written to, by painting, are in memory from then on and are never dropped.
//
// A face that cannot be read (the file is damaged, was changed or cut short by another program)
// becomes a placeholder of checks of the right size; the fault is noted here, once a face, and the
// placeholder is marked (`FaceTexels::isDamaged`). Whatever writes texels out refuses marked ones.
#pragma once

#include "core/texture/face_reader.h"
#include "core/texture/face_texels.h"
#include "core/texture/texel_format.h"

#include <array>
#include <atomic>
#include <cstdint>
#include <list>
#include <memory>
#include <mutex>
#include <string>
#include <unordered_map>
#include <vector>

namespace trixel {

/// Why a face could not be read, as a whole sentence.
struct FaceFault
{
    FaceId face{};
    std::string sentence;

    bool operator==(const FaceFault&) const = default;
};

/// The faces of one file: reads them, keeps those read last, remembers which could not be read.
/// All of it from several threads at once.
class StoredFaces : public std::enable_shared_from_this<StoredFaces>
{
public:
    static constexpr std::uint64_t kDefaultBudget = std::uint64_t{1} << 30U;

    /// \param budget  bytes of texels that the cache may keep; what is pinned or held counts extra
    static std::shared_ptr<StoredFaces> make(const TexelFormat& format,
                                             std::unique_ptr<const FaceReader> reader,
                                             std::uint64_t budget = kDefaultBudget);

    const TexelFormat& format() const { return m_format; }
    std::uint64_t budget() const { return m_budget; }

    /// A face that is read when first asked for. \param level  its own, as the reader knows it
    FaceTexels face(FaceId face, Level level);

    /// Bytes that the cache keeps; at most the budget.
    std::uint64_t cachedBytes() const;
    /// Bytes that faces hold because `bytes` was asked for.
    std::uint64_t heldBytes() const { return m_heldBytes; }
    /// Bytes of texels that were read so far, whatever became of them.
    std::uint64_t readBytes() const { return m_readBytes; }

    /// How many faces could not be read.
    std::size_t faultCount() const { return m_faultCount; }
    /// The first of them, in the order in which they were met. \param from  those to leave out
    std::vector<FaceFault> faults(std::size_t from = 0) const;
    /// Whether the face was asked for and could not be read.
    bool isDamaged(FaceId face) const;

private:
    friend class StoredFace;
    using Words = std::shared_ptr<std::uint64_t[]>;
    struct Cached
    {
        FaceId face{};
        Words words;
        std::uint64_t bytes = 0;
    };
    using Order = std::list<Cached>;

    StoredFaces(const TexelFormat& format,
                std::unique_ptr<const FaceReader> reader,
                std::uint64_t budget);

    std::size_t byteCount(Level level) const { return level.texelCount() * m_format.texelBytes(); }
    /// The face's texels from cache or record, else read and cached.
    Words texels(const StoredFace& record);
    Words read(FaceId face, Level level);
    Words fromCache(FaceId face);
    void dropFromCache(FaceId face);
    void cache(FaceId face, const Words& words, std::uint64_t bytes);
    void note(FaceId face, std::string sentence);
    void fillWithChecks(Level level, std::span<std::byte> texels) const;

    TexelFormat m_format;
    std::unique_ptr<const FaceReader> m_reader;
    std::uint64_t m_budget;

    // One face is read by one thread at a time, different faces side by side.
    std::array<std::mutex, 64> m_reading;

    mutable std::mutex m_cacheMutex;
    Order m_order; ///< read last comes first
    std::unordered_map<std::uint32_t, Order::iterator> m_cached;
    std::uint64_t m_cachedBytes = 0;

    mutable std::mutex m_faultMutex;
    std::vector<FaceFault> m_faults;
    std::unordered_map<std::uint32_t, std::size_t> m_faultOf;
    std::atomic<std::size_t> m_faultCount = 0;

    std::atomic<std::uint64_t> m_heldBytes = 0;
    std::atomic<std::uint64_t> m_readBytes = 0;
};

/// What the copies of one stored face share: where it lies and, once `bytes` was asked for, its
/// texels.
class StoredFace
{
public:
    StoredFace(std::shared_ptr<StoredFaces> faces, FaceId face, Level level);
    StoredFace(const StoredFace&) = delete;
    StoredFace& operator=(const StoredFace&) = delete;
    ~StoredFace();

    /// Reads at the first call; from then on the texels stay.
    const std::byte* hold();
    bool isHeld() const { return m_ready.load(std::memory_order_acquire) != nullptr; }
    /// The texels, held already or from the cache, which keeps them; does not hold them.
    std::shared_ptr<std::uint64_t[]> pin();
    bool isDamaged() const { return m_faces->isDamaged(m_face); }

    std::span<const std::byte> mean() const { return m_faces->m_reader->mean(m_face); }
    bool stores(Level level) const { return m_faces->m_reader->stores(m_face, level); }
    std::optional<FaceTexels> coarser(Level level) const;
    /// Another record of the same face, which holds nothing.
    FaceTexels anew() const { return m_faces->face(m_face, m_level); }

private:
    friend class StoredFaces;
    std::shared_ptr<StoredFaces> m_faces;
    FaceId m_face;
    Level m_level;
    std::once_flag m_once;
    std::shared_ptr<std::uint64_t[]> m_words;
    std::atomic<const std::byte*> m_ready = nullptr;
};

} // namespace trixel
