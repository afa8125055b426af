// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/look/value_axis.h"

#include "core/base/check.h"

#include <algorithm>
#include <cmath>

namespace trixel::ui {

namespace {

double roundStep(double step)
{
    const double power = std::pow(10.0, std::floor(std::log10(step)));
    for (const double times : {1.0, 2.0, 5.0}) {
        if (times * power >= step * (1 - 1e-9)) {
            return times * power;
        }
    }
    return 10 * power;
}

/// Digits that tell `value` from its neighbours `step` away.
QString tickText(double value, double step)
{
    const double size = std::max(std::abs(value), step);
    const int digits =
        static_cast<int>(std::floor(std::log10(size)) - std::floor(std::log10(step)));
    return QString::number(value, 'g', std::clamp(digits + 1, 1, 9));
}

} // namespace

std::vector<AxisTick> roundTicks(double low, double high, int most)
{
    check(low < high && std::isfinite(low) && std::isfinite(high) && most >= 2, "a range");
    const double step = roundStep((high - low) / most);
    std::vector<AxisTick> ticks;
    const double first = std::ceil(low / step - 1e-9);
    for (int k = 0; k <= most; ++k) {
        double value = (first + k) * step;
        if (value > high + 1e-9 * step) {
            break;
        }
        value = std::abs(value) < 1e-9 * step ? 0 : value;
        ticks.push_back({value, tickText(value, step)});
    }
    return ticks;
}

} // namespace trixel::ui
