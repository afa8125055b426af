// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/viewport/map_scale.h"

#include <QCoreApplication>

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

double MapScale::position(double value) const
{
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
    if (map == ViewMapKind::Fit) {
        return QString("%1 / 255").arg(QString::number(255 * value, 'g', 3));
    }
    return map == ViewMapKind::Condition
               ? QString("%1 : 1").arg(QString::number(value, 'g', 3))
               : QString("%1 %").arg(QString::number(100 * value, 'g', 3));
}

} // namespace trixel::ui
