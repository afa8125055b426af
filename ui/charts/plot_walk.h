// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/charts/plot.h"

#include <optional>

namespace trixel::ui {

/// A step of the keyboard from point to point.
enum class PlotStep {
    NextOnCurve,
    LastOnCurve, ///< the one before
    NextCurve,
    LastCurve,
    NextOnFront,
    LastOnFront,
    FrontStart,
    FrontEnd
};

/// Where a step leads: along a curve in its order; to the neighbouring curve's point nearest in x;
/// along the front from left to right, entered where it is nearest. A step beyond the end stays;
/// curves go round. From nowhere every step leads to the front's start.
/// \return  nothing for a plot without points
std::optional<PlotMark> step(const Plot& plot, std::optional<PlotMark> from, PlotStep step);

} // namespace trixel::ui
