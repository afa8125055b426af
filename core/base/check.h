// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <source_location>

namespace trixel {

/// Prints the place and stops the program; the end of a broken promise.
[[noreturn]] void checkFailed(const char* condition, const std::source_location& where);

/// Always-on check of what the caller promised (a valid index, matching sizes). Not for input.
constexpr void check(bool holds,
                     const char* condition,
                     const std::source_location& where = std::source_location::current())
{
    if (!holds) [[unlikely]] {
        checkFailed(condition, where);
    }
}

} // namespace trixel
