// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/charts/list_axis.h"

#include "core/base/check.h"

#include <algorithm>

namespace trixel::ui {

ListAxis::ListAxis(std::vector<QString> names)
    : m_names(std::move(names))
{
    check(!m_names.empty(), "an axis of at least one name");
}

double ListAxis::place(double position) const
{
    return std::clamp((position + 0.5) / static_cast<double>(m_names.size()), 0.0, 1.0);
}

std::vector<Tick> ListAxis::ticks(int mostTexts) const
{
    const std::size_t room = static_cast<std::size_t>(std::max(1, mostTexts));
    const std::size_t every = (m_names.size() + room - 1) / room;
    std::vector<Tick> ticks;
    for (std::size_t k = 0; k < m_names.size(); ++k) {
        const bool isNamed = k % every == 0;
        ticks.push_back({place(static_cast<double>(k)), isNamed ? m_names[k] : QString()});
    }
    return ticks;
}

} // namespace trixel::ui
