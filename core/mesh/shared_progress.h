// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/progress.h"

#include <atomic>
#include <cstddef>
#include <mutex>

namespace trixel {

/// Progress of equal steps done by several threads, reported from one at a time.
class SharedProgress
{
public:
    SharedProgress(Progress& progress, std::size_t steps)
        : m_progress(progress)
        , m_steps(steps)
    {
    }

    /// False once the work is to stop.
    bool goesOn() const { return !m_stopped; }

    /// One more step is done.
    void step()
    {
        const std::lock_guard lock(m_mutex);
        ++m_done;
        if (!m_stopped &&
            !m_progress.report(static_cast<double>(m_done) / static_cast<double>(m_steps))) {
            m_stopped = true;
        }
    }

private:
    Progress& m_progress;
    std::size_t m_steps;
    std::mutex m_mutex;
    std::size_t m_done = 0;
    std::atomic<bool> m_stopped{false};
};

} // namespace trixel
