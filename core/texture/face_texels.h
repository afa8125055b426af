// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/level.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>

namespace trixel {

/// The texels of one face: all 4^n of them in Ptex packing, or one value if they are all alike.
/// A value type: copies share their bytes until one of them is written to.
class FaceTexels
{
public:
    /// No texels at all; only a placeholder.
    FaceTexels() = default;

    /// A face of one colour that stores one texel. \param texel  the bytes of one texel
    static FaceTexels constant(Level level, std::span<const std::byte> texel);

    /// A face that stores every texel. \param texels  4^n texels in packed order
    static FaceTexels full(Level level, std::size_t texelBytes, std::span<const std::byte> texels);

    /// The same value at another level, sharing its bytes. The face is constant (checked).
    FaceTexels atLevel(Level level) const;

    Level level() const { return m_level; }
    bool isConstant() const { return m_constant; }
    std::size_t texelBytes() const { return m_texelBytes; }

    /// One texel if constant, else 4^n texels in packed order.
    std::span<const std::byte> bytes() const;

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
    bool sharesBytesWith(const FaceTexels& other) const { return m_words == other.m_words; }

    /// Equal level and equal texels; a constant face equals the spread-out one.
    bool operator==(const FaceTexels& other) const;

private:
    FaceTexels(Level level, bool constant, std::size_t texelBytes);

    std::byte* data() const { return reinterpret_cast<std::byte*>(m_words.get()); }

    // Words keep channel values aligned for direct access.
    std::shared_ptr<std::uint64_t[]> m_words;
    std::uint32_t m_texelBytes = 0;
    Level m_level;
    bool m_constant = true;
};

} // namespace trixel
