// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/progress.h"

#include <cstddef>

namespace trixel {

/// Reports every few thousand rows of a long loop.
class RowProgress
{
public:
    /// \param total  what `done` will be in the end
    RowProgress(Progress& progress, std::size_t total)
        : m_progress(progress)
        , m_total(total)
    {
    }

    /// To be called once a row; false when the work is to stop.
    bool goesOn(std::size_t done)
    {
        if (m_rows++ % kRows != 0) {
            return true;
        }
        return m_progress.report(static_cast<double>(done) / static_cast<double>(m_total));
    }

private:
    static constexpr std::size_t kRows = std::size_t{1} << 15U;

    Progress& m_progress;
    std::size_t m_total;
    std::size_t m_rows = 0;
};

} // namespace trixel
