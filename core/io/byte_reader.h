// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <bit>
#include <cstddef>
#include <cstring>
#include <optional>
#include <span>
#include <type_traits>

namespace trixel {

static_assert(std::endian::native == std::endian::little, "file formats are read as they lie");

/// Takes little-endian values off the front of a stretch of bytes; never looks past its end.
class ByteReader
{
public:
    explicit ByteReader(std::span<const std::byte> bytes)
        : m_bytes(bytes)
    {
    }

    std::size_t remaining() const { return m_bytes.size(); }

    /// The next value, or nothing when too few bytes remain.
    template <class T>
    std::optional<T> take()
    {
        static_assert(std::is_trivially_copyable_v<T>);
        if (m_bytes.size() < sizeof(T)) {
            return std::nullopt;
        }
        T value;
        std::memcpy(&value, m_bytes.data(), sizeof(T));
        m_bytes = m_bytes.subspan(sizeof(T));
        return value;
    }

    /// The next `count` bytes, or nothing when fewer remain.
    std::optional<std::span<const std::byte>> takeBytes(std::size_t count)
    {
        if (m_bytes.size() < count) {
            return std::nullopt;
        }
        const auto taken = m_bytes.first(count);
        m_bytes = m_bytes.subspan(count);
        return taken;
    }

private:
    std::span<const std::byte> m_bytes;
};

} // namespace trixel
