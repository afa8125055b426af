// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/error_sums.h"

#include <algorithm>
#include <cmath>

namespace trixel {

void ErrorSums::add(double answer, double truth, double range)
{
    if (!std::isfinite(truth)) {
        m_errors.push_back(std::isfinite(answer) ? 1.0F : 0.0F);
        return;
    }
    m_errors.push_back(std::isfinite(answer) ? static_cast<float>(std::abs(answer - truth) / range)
                                             : 1.0F);
}

void ErrorSums::tell(StudyPoint& point) const
{
    point.rms = point.p99 = point.worst = 0;
    if (m_errors.empty()) {
        return;
    }
    double squares = 0;
    for (const float error : m_errors) {
        squares += static_cast<double>(error) * static_cast<double>(error);
    }
    point.rms = std::sqrt(squares / static_cast<double>(m_errors.size()));
    std::vector<float> sorted = m_errors;
    const std::size_t rank = (99 * sorted.size() + 99) / 100 - 1;
    std::ranges::nth_element(sorted, sorted.begin() + static_cast<std::ptrdiff_t>(rank));
    point.p99 = static_cast<double>(sorted[rank]);
    point.worst = static_cast<double>(std::ranges::max(m_errors));
}

} // namespace trixel
