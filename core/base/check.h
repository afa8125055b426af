// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace trixel {

/// Place of a call, like std::source_location, which clang 14 (the fuzz targets) lacks.
struct CallPlace
{
    const char* file;
    const char* function;
    int line;

    static constexpr CallPlace current(const char* file = __builtin_FILE(),
                                       const char* function = __builtin_FUNCTION(),
                                       int line = __builtin_LINE())
    {
        return {file, function, line};
    }
};

/// Prints the place and stops the program; the end of a broken promise.
[[noreturn]] void checkFailed(const char* condition, const CallPlace& where);

/// Always-on check of what the caller promised (a valid index, matching sizes). Not for input.
constexpr void
check(bool holds, const char* condition, const CallPlace& where = CallPlace::current())
{
    if (!holds) [[unlikely]] {
        checkFailed(condition, where);
    }
}

} // namespace trixel
