// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/charts/plot_layout.h"

namespace trixel::ui {

/// Finds places in the frame for the series' names, those on the front first, then for the tags of
/// the front's points. Everything else of the layout stands already.
void placeLabels(const Plot& plot, const PlotFonts& fonts, PlotLayout& layout);

} // namespace trixel::ui
