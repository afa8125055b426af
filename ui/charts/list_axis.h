// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/charts/log_axis.h"

#include <vector>

namespace trixel::ui {

/// An axis of things that have names rather than sizes, or of numbers of which some are none:
/// evenly spaced in their order.
class ListAxis
{
public:
    /// \param names  at least one (checked)
    explicit ListAxis(std::vector<QString> names);

    /// Where a position of the list lies, in (0, 1).
    double place(double position) const;
    /// A line at every position; the first and then every second, fifth, … are named.
    std::vector<Tick> ticks(int mostTexts) const;

private:
    std::vector<QString> m_names;
};

} // namespace trixel::ui
