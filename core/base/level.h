// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/check.h"

#include <compare>
#include <cstddef>
#include <cstdint>
#include <optional>

namespace trixel {

/// Resolution of a face as a power of two: level n has 2^n texels along each edge, 4^n in all.
class Level
{
public:
    static constexpr int kMax = 12;

    constexpr Level() = default;

    /// \param log2 in [0, kMax] (checked)
    explicit constexpr Level(int log2)
        : m_log2(static_cast<std::uint8_t>(log2))
    {
        check(log2 >= 0 && log2 <= kMax, "level in [0, 12]");
    }

    /// A level from input, or nothing when it is outside [0, kMax].
    static constexpr std::optional<Level> fromInput(long long log2)
    {
        return log2 >= 0 && log2 <= kMax ? std::optional(Level(static_cast<int>(log2)))
                                         : std::nullopt;
    }

    constexpr int log2() const { return m_log2; }
    /// Texels along an edge, R = 2^n.
    constexpr std::uint32_t resolution() const { return 1U << m_log2; }
    /// Texels of the face, 4^n.
    constexpr std::uint32_t texelCount() const { return 1U << (2U * m_log2); }
    /// The level `steps` coarser, not below 0.
    constexpr Level coarser(int steps = 1) const
    {
        return Level(steps > m_log2 ? 0 : m_log2 - steps);
    }

    constexpr auto operator<=>(const Level&) const = default;

private:
    std::uint8_t m_log2 = 0;
};

} // namespace trixel
