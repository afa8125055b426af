// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/viewport/map_scale.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>

namespace trixel::ui {

MapScale MapScale::of(ViewMapKind map)
{
    MapScale scale;
    if (map == ViewMapKind::Condition) {
        scale.m_low = 1;
        scale.m_high = 100;
        scale.m_ticks = {{1, "1"}, {3, "3"}, {10, "10"}, {30, "30"}, {100, "≥ 100"}};
    } else {
        scale.m_low = 1e-5;
        scale.m_high = 1;
        scale.m_ticks = {{1e-5, "≤ 0.001"},
                         {1e-4, "0.01"},
                         {1e-3, "0.1"},
                         {1e-2, "1"},
                         {1e-1, "10"},
                         {1, "100 %"}};
    }
    return scale;
}

MapScale MapScale::about(double tolerance)
{
    // A fit lets no face err more than three tolerances.
    MapScale scale;
    scale.m_low = 0.03 * tolerance;
    scale.m_high = 3 * tolerance;
    for (const double part : {0.03, 0.1, 0.3, 1.0, 3.0}) {
        const double value = part * tolerance;
        scale.m_ticks.push_back({value, QString::number(255 * value, 'g', 2)});
    }
    return scale;
}

MapScale MapScale::ofLevels(int low, int high)
{
    MapScale scale;
    scale.m_isLinear = true;
    scale.m_low = low;
    scale.m_high = std::max(high, low + 1);
    for (int level = low; level <= high; ++level) {
        scale.m_ticks.push_back({double(level), QString::number(level)});
    }
    return scale;
}

MapScale MapScale::ofDensities(double low, double high)
{
    constexpr double kLeastRatio = 4; // alike densities look alike
    MapScale scale;
    const double middle = std::sqrt(low * high);
    const double ratio = std::sqrt(std::max(high / low, kLeastRatio));
    scale.m_low = middle / ratio;
    scale.m_high = middle * ratio;
    constexpr int kTicks = 4;
    for (int k = 0; k <= kTicks; ++k) {
        const double value = scale.m_low * std::pow(ratio, 2.0 * k / kTicks);
        scale.m_ticks.push_back({value, QString::number(value, 'g', 3)});
    }
    return scale;
}

double MapScale::position(double value) const
{
    if (m_isLinear) {
        return (value - m_low) / (m_high - m_low);
    }
    return std::log(value / m_low) / std::log(m_high / m_low);
}

QString MapScale::text(ViewMapKind map, double value)
{
    if (std::isnan(value)) {
        return QCoreApplication::translate("MapScale", "refused");
    }
    if (std::isinf(value)) {
        return "∞";
    }
    if (map == ViewMapKind::Level) {
        return QCoreApplication::translate("MapScale", "level %1").arg(value);
    }
    if (map == ViewMapKind::Density) {
        return QCoreApplication::translate("MapScale", "%1 texels a unit")
            .arg(QString::number(value, 'g', 3));
    }
    if (map == ViewMapKind::Fit) {
        return QString("%1 / 255").arg(QString::number(255 * value, 'g', 3));
    }
    return map == ViewMapKind::Condition
               ? QString("%1 : 1").arg(QString::number(value, 'g', 3))
               : QString("%1 %").arg(QString::number(100 * value, 'g', 3));
}

} // namespace trixel::ui
