// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <vector>

namespace trixel::ui {

/// A number on an axis and how it is written.
struct AxisTick
{
    double value = 0;
    QString text;
};

/// Round numbers within a range, 1, 2 or 5 times a power of ten apart, each written with as many
/// digits as tell it from the next.
/// \param low, high  finite, low < high (checked)
/// \param most       how many at most (>= 2, checked)
std::vector<AxisTick> roundTicks(double low, double high, int most);

} // namespace trixel::ui
