// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/study/study.h"

#include <cstdint>
#include <vector>

namespace trixel {

/// Gathers errors of single values and tells RMS, 99th percentile and worst of them.
class ErrorSums
{
public:
    /// \param range  what the error is a fraction of, above 0. An answer that is not finite where
    ///               the true value is counts as wrong by the whole range; where both are not
    ///               finite there is no error.
    void add(double answer, double truth, double range);

    void join(const ErrorSums& other)
    {
        m_errors.insert(m_errors.end(), other.m_errors.begin(), other.m_errors.end());
    }

    std::size_t count() const { return m_errors.size(); }

    /// Fills rms, p99 and worst; 0 where nothing was added. The 99th percentile is the least error
    /// that 99 of a hundred do not exceed.
    void tell(StudyPoint& point) const;

private:
    std::vector<float> m_errors; // absolute, fractions of the range
};

} // namespace trixel
