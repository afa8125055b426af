// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/parallel.h"
#include "core/base/progress.h"
#include "core/base/result.h"

#include <atomic>
#include <cstddef>
#include <thread>

namespace trixel {

/// Calls work(index) for every index below `count`, from several threads, and reports between them
/// from the calling one: so an index should be a matter of milliseconds. Fails only when cancelled,
/// and then leaves some out.
template <class Work>
Status forEachInParallel(std::size_t count, Threads threads, Progress& progress, const Work& work)
{
    const auto caller = std::this_thread::get_id();
    std::atomic<bool> stopped{!progress.report(0)};
    std::atomic<std::size_t> done{0};
    parallelFor(count, 1, threads, [&](std::size_t begin, std::size_t end) {
        for (std::size_t k = begin; k < end && !stopped; ++k) {
            work(k);
            const std::size_t sofar = ++done;
            if (std::this_thread::get_id() == caller &&
                !progress.report(static_cast<double>(sofar) / static_cast<double>(count))) {
                stopped = true;
            }
        }
    });
    return stopped ? Status(cancelled()) : Status();
}

} // namespace trixel
