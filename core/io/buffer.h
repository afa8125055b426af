// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <memory>
#include <span>

namespace trixel {

/// Bytes to work in, reused from one piece of work to the next: grows, never shrinks, is never
/// cleared.
class Buffer
{
public:
    /// The first `size` bytes; what they hold is whatever was left there.
    std::span<std::byte> first(std::size_t size)
    {
        if (size > m_capacity) {
            m_bytes = std::make_unique_for_overwrite<std::byte[]>(size);
            m_capacity = size;
        }
        return {m_bytes.get(), size};
    }

private:
    std::unique_ptr<std::byte[]> m_bytes;
    std::size_t m_capacity = 0;
};

} // namespace trixel
