// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/progress.h"

#include <atomic>
#include <cstdint>
#include <mutex>

namespace trixel {

/// Progress of work that several threads share.
class SharedProgress
{
public:
    /// \param total  what the steps add up to, at least 1
    SharedProgress(Progress& progress, std::uint64_t total)
        : m_progress(progress)
        , m_total(total)
    {
    }

    /// A thread has done so much more; false when the work is to stop.
    bool advance(std::uint64_t step)
    {
        m_done += step;
        // Whoever finds another thread reporting lets it report for both.
        if (const std::unique_lock lock(m_mutex, std::try_to_lock); lock && !m_stopped) {
            const double fraction = static_cast<double>(m_done) / static_cast<double>(m_total);
            m_stopped = !m_progress.report(fraction < 1 ? fraction : 1);
        }
        return !m_stopped;
    }

    bool isStopped() const { return m_stopped; }

private:
    Progress& m_progress;
    std::uint64_t m_total;
    std::atomic<std::uint64_t> m_done{0};
    std::atomic<bool> m_stopped{false};
    std::mutex m_mutex;
};

} // namespace trixel
