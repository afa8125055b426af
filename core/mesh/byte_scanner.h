// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/check.h"
#include "core/base/result.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <string>
#include <string_view>

namespace trixel {

/// Reads numbers of either byte order from binary data. The caller asks `has` before it reads.
class ByteScanner
{
public:
    /// \param firstOffset  place of the data in its file, for messages
    ByteScanner(std::string_view bytes, std::endian order, std::size_t firstOffset = 0)
        : m_bytes(bytes)
        , m_swapped(order != std::endian::native)
        , m_firstOffset(firstOffset)
    {
    }

    std::size_t left() const { return m_bytes.size() - m_at; }
    bool has(std::size_t bytes) const { return bytes <= left(); }
    /// Place in the file.
    std::size_t offset() const { return m_firstOffset + m_at; }

    /// \pre has(sizeof(T)) (checked)
    template <class T>
    T read()
    {
        check(has(sizeof(T)), "bytes are there");
        std::array<char, sizeof(T)> bytes;
        std::memcpy(bytes.data(), m_bytes.data() + m_at, sizeof(T));
        m_at += sizeof(T);
        if (m_swapped) {
            std::reverse(bytes.begin(), bytes.end());
        }
        return std::bit_cast<T>(bytes);
    }

    /// \pre has(bytes) (checked)
    void skip(std::size_t bytes)
    {
        check(has(bytes), "bytes are there");
        m_at += bytes;
    }

    /// "byte 84: expected <what>, found <found>".
    tl::unexpected<Error> expected(const std::string& what, const std::string& found) const
    {
        return expectedAt(offset(), what, found);
    }

    static tl::unexpected<Error>
    expectedAt(std::size_t offset, const std::string& what, const std::string& found)
    {
        return contentsError("byte " + std::to_string(offset) + ": expected " + what + ", found " +
                             found);
    }

private:
    std::string_view m_bytes;
    std::size_t m_at = 0;
    bool m_swapped;
    std::size_t m_firstOffset;
};

} // namespace trixel
