// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include "render/color_map.h"
#include "ui/viewport/view_settings.h"

#include <vector>

namespace trixel::ui {

/// How numbers become places on a colour scale: by their logarithm, levels as they are.
class MapScale
{
public:
    struct Tick
    {
        double value = 0;
        QString text;
    };

    /// \param map  Condition, Error or Difference
    static MapScale of(ViewMapKind map);
    /// Of Fit: errors about a tolerance, both in the unit of the texel values.
    static MapScale about(double tolerance);
    /// Of Level: from the lowest to the highest that there are.
    static MapScale ofLevels(int low, int high);
    /// Of Density: from the lowest to the highest that there are, both above 0.
    static MapScale ofDensities(double low, double high);

    /// 0 at the lowest value of the scale, 1 at the highest; beyond them less or more. Zero is
    /// infinitely low.
    double position(double value) const;
    render::Rgb color(double value) const { return render::mapColor(position(value)); }
    const std::vector<Tick>& ticks() const { return m_ticks; }

    /// A number of the map as people read it: "3.2 : 1", "0.034 %", "0.42 / 255", "level 3".
    static QString text(ViewMapKind map, double value);

private:
    double m_low = 1;
    double m_high = 10;
    bool m_isLinear = false;
    std::vector<Tick> m_ticks;
};

} // namespace trixel::ui
