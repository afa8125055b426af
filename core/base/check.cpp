// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/check.h"

#include <cstdio>
#include <cstdlib>

namespace trixel {

void checkFailed(const char* condition, const CallPlace& where)
{
    std::fprintf(stderr,
                 "%s:%d: %s: broken promise: %s\n",
                 where.file,
                 where.line,
                 where.function,
                 condition);
    std::abort();
}

} // namespace trixel
