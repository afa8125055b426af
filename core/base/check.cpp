// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/check.h"

#include <cstdio>
#include <cstdlib>

namespace trixel {

void checkFailed(const char* condition, const std::source_location& where)
{
    std::fprintf(stderr,
                 "%s:%u: %s: broken promise: %s\n",
                 where.file_name(),
                 where.line(),
                 where.function_name(),
                 condition);
    std::abort();
}

} // namespace trixel
