// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include "ui/charts/quantity.h"

#include <span>
#include <vector>

namespace trixel::ui {

/// A line across the plot; one with a text is numbered.
struct Tick
{
    double place = 0; ///< along the axis, [0, 1]
    QString text;
};

/// A logarithmic axis that holds given values. Zero and what is too small for the scale share one
/// line at its lower end, infinity has one at the upper, so that nothing is lost and nothing
/// squeezes the rest.
class LogAxis
{
public:
    /// An axis from 1 to 10.
    LogAxis() = default;
    /// \param values   those that are negative or not a number are passed over
    /// \param decades  that the axis spans at most: what is smaller than the largest value by more
    ///                 goes to the line at the lower end
    LogAxis(std::span<const double> values, Quantity quantity, double decades = 9);

    /// Where a value lies, [0, 1] for values the axis was made of.
    double place(double value) const;
    /// Whether a value shares the line at the lower end.
    bool isBelow(double value) const { return m_hasFloor && !(value >= m_least); }
    double least() const { return m_least; }
    double most() const { return m_most; }

    /// Ticks at round numbers, numbered as densely as reads well.
    /// \param mostTexts  how many numbers there is room for
    std::vector<Tick> ticks(int mostTexts) const;

private:
    double placeOfLog(double log) const;
    QString floorText() const;
    int textsWith(std::span<const int> digits, int everyDecades) const;

    double m_least = 1;
    double m_most = 10;
    double m_low = 0;  ///< log10 of the value at `place` 0 (or the end of the floor)
    double m_high = 1; ///< log10 of the value at `place` 1
    bool m_hasFloor = false;
    bool m_hasCeiling = false; ///< a line for infinity
    double m_mostBelow = 0;    ///< the largest value on the line at the lower end
    Quantity m_quantity = Quantity::Number;
};

} // namespace trixel::ui
