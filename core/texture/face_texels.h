// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/level.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>

namespace trixel {

class StoredFace;

/// The texels of one face: all 4^n of them in Ptex packing, or one value if they are all alike.
/// A value type: copies share their bytes until one of them is written to.
///
/// The texels of a *stored* face lie in a file until they are asked for (stored_faces.h says how,
/// and what becomes of faces that cannot be read). Level, texel size, `isConstant`, `byteCount`,
/// `isLoaded`, `mean` and copying never read; `bytes`, `texel`, comparing and writing do.
class FaceTexels
{
public:
    /// No texels at all; only a placeholder.
    FaceTexels() = default;

    /// A face of one colour that stores one texel. \param texel  the bytes of one texel
    static FaceTexels constant(Level level, std::span<const std::byte> texel);

    /// A face that stores every texel. \param texels  4^n texels in packed order
    static FaceTexels full(Level level, std::size_t texelBytes, std::span<const std::byte> texels);

    /// A face whose texels are read when asked for; `StoredFaces::face` makes them.
    static FaceTexels stored(std::shared_ptr<StoredFace> face, Level level, std::size_t texelBytes);

    /// The same value at another level, sharing its bytes. The face is constant (checked).
    FaceTexels atLevel(Level level) const;

    Level level() const { return m_level; }
    /// Whether one value is kept for all texels. A face that keeps all of them may still be of one
    /// colour (see `collapsed`).
    bool isConstant() const { return m_constant; }
    std::size_t texelBytes() const { return m_texelBytes; }

    /// One texel if constant, else 4^n texels in packed order. Valid as long as this or a copy of
    /// it lives and is not written to. A stored face is read and then stays in memory.
    std::span<const std::byte> bytes() const;
    /// How many bytes that is.
    std::size_t byteCount() const
    {
        return std::size_t{m_texelBytes} * (m_constant ? 1 : m_level.texelCount());
    }

    /// The stored bytes of one texel.
    std::span<const std::byte> texel(std::size_t index) const
    {
        return bytes().subspan(m_constant ? 0 : index * m_texelBytes, m_texelBytes);
    }

    /// Every texel of the face, to be written to: a constant face is spread out first, and bytes
    /// shared with another copy are copied first.
    std::span<std::byte> writable();

    /// The same face with one value if all its texels are alike to the bit, else itself.
    FaceTexels collapsed() const;

    /// Whether both share the same bytes in memory (not merely equal ones).
    bool sharesBytesWith(const FaceTexels& other) const { return m_held == other.m_held; }

    /// Whether this is a stored face, nobody having written to it.
    bool isStored() const { return m_stored; }
    /// Whether `bytes` answers from memory: true but for stored faces not yet asked for it.
    bool isLoaded() const;
    /// The same texels in memory, without this face holding on to them: what walks over many faces
    /// asks for, so that memory stays within the cache's budget. Itself if not stored.
    FaceTexels pinned() const;
    /// A stored face as if it was never asked for its texels; others themselves.
    FaceTexels released() const;

    /// One texel without reading the face: the value of a constant face, the mean of a stored one
    /// as its file keeps it. Nothing for texels in memory that vary. Valid as `bytes`.
    std::optional<std::span<const std::byte>> mean() const;
    /// Whether `storedLevel` has an answer: for every level of a constant face, and those coarser
    /// ones that the file of a stored face keeps. Reads nothing.
    bool hasStoredLevel(Level level) const;
    /// A first look at the face at a coarser level, as its file keeps it: reads that level alone.
    /// It may differ from what `reduced` makes (other programs cut off where Trixel rounds), and
    /// is nothing where the file is damaged. From any thread; not cached.
    /// \param level  not above the face's (checked)
    std::optional<FaceTexels> storedLevel(Level level) const;

    /// Whether the face could not be read and these texels, or some of them, stand in for it. Known
    /// once they were asked for; stays with copies, and while it is painted over.
    bool isDamaged() const;

    /// Equal level and equal texels; a constant face equals the spread-out one.
    bool operator==(const FaceTexels& other) const;

private:
    FaceTexels(Level level, bool constant, std::size_t texelBytes);

    /// Of a face that is not stored.
    std::byte* data() const { return static_cast<std::byte*>(m_held.get()); }
    StoredFace& record() const;

    // The texels as std::uint64_t[], which keeps channel values aligned for direct access; a
    // StoredFace if stored.
    std::shared_ptr<void> m_held;
    std::uint32_t m_texelBytes = 0;
    Level m_level;
    bool m_constant = true;
    bool m_stored = false;
    bool m_damaged = false;
};

} // namespace trixel
