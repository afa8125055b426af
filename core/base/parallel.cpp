// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/parallel.h"

#include "core/base/check.h"

#include <algorithm>
#include <atomic>
#include <thread>
#include <vector>

namespace trixel {

Threads Threads::all()
{
    return Threads{std::max(1U, std::thread::hardware_concurrency())};
}

void parallelFor(std::size_t count,
                 std::size_t grain,
                 Threads threads,
                 const std::function<void(std::size_t begin, std::size_t end)>& work)
{
    check(grain > 0, "grain of at least one item");
    if (count == 0) {
        return;
    }
    const std::size_t ranges = (count + grain - 1) / grain;
    const std::size_t workers = std::clamp<std::size_t>(threads.count, 1, ranges);
    if (workers == 1) {
        work(0, count);
        return;
    }
    std::atomic<std::size_t> next{0};
    const auto drain = [&] {
        for (std::size_t range = next++; range < ranges; range = next++) {
            work(range * grain, std::min(count, (range + 1) * grain));
        }
    };
    std::vector<std::jthread> helpers;
    helpers.reserve(workers - 1);
    for (std::size_t i = 1; i < workers; ++i) {
        helpers.emplace_back(drain);
    }
    drain();
}

} // namespace trixel
