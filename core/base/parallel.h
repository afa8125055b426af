// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>

namespace trixel {

/// How many threads a piece of work may use.
struct Threads
{
    unsigned count = 1;

    /// All cores of the machine.
    static Threads all();
};

/// Calls work(begin, end) on disjoint ranges that cover [0, count), from several threads.
/// Ranges are handed out in order, `grain` items at a time; small work stays on the calling thread.
/// Returns when all are done. `work` must not throw, and its result must not depend on the ranges.
void parallelFor(std::size_t count,
                 std::size_t grain,
                 Threads threads,
                 const std::function<void(std::size_t begin, std::size_t end)>& work);

} // namespace trixel
