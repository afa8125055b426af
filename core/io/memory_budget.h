// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"

#include <cstdint>
#include <string>
#include <string_view>

namespace trixel {

/// What reading one file may allocate; asked before each allocation whose size the file names.
class MemoryBudget
{
public:
    static constexpr std::uint64_t kDefaultBytes = std::uint64_t{8} << 30U;

    explicit MemoryBudget(std::uint64_t bytes = kDefaultBytes)
        : m_bytes(bytes)
        , m_left(bytes)
    {
    }

    std::uint64_t left() const { return m_left; }

    /// Sets bytes aside. Fails with a sentence when they exceed what is left.
    /// \param what  what needs them, in the plural ("the face infos")
    Status take(std::uint64_t bytes, std::string_view what)
    {
        if (bytes > m_left) {
            return contentsError(std::string(what) + " would take " + std::to_string(bytes) +
                                 " bytes of memory; " + std::to_string(m_left) + " of " +
                                 std::to_string(m_bytes) + " are left for one file");
        }
        m_left -= bytes;
        return {};
    }

private:
    std::uint64_t m_bytes;
    std::uint64_t m_left;
};

} // namespace trixel
