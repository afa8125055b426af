// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/charts/plot.h"

#include <algorithm>

namespace trixel::ui {

std::vector<PlotMark> frontOf(const Plot& plot)
{
    std::vector<PlotMark> front;
    for (std::size_t s = 0; s < plot.series.size(); ++s) {
        for (std::size_t p = 0; p < plot.series[s].points.size(); ++p) {
            if (plot.series[s].points[p].onFront) {
                front.push_back({s, p});
            }
        }
    }
    std::ranges::stable_sort(front, {}, [&](PlotMark mark) { return pointOf(plot, mark).x; });
    return front;
}

} // namespace trixel::ui
