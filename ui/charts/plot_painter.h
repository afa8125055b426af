// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/charts/plot_layout.h"

#include <optional>

class QPainter;

namespace trixel::ui {

/// How writing gets onto the device.
enum class Lettering {
    Text,    ///< by its fonts, sharpest on screens
    Outlines ///< as drawn shapes, which look the same where the fonts are not
};

struct PlotLook
{
    PlotTheme theme;
    Lettering lettering = Lettering::Text;
    std::optional<std::size_t> lifted; ///< a series that stands out, the others fade
    std::optional<PlotMark> chosen;    ///< the point in use: ringed
};

/// Draws the whole plot, its background included. One drawing serves the window, pictures and SVG.
void paintPlot(QPainter& painter,
               const Plot& plot,
               const PlotLayout& layout,
               const PlotFonts& fonts,
               const PlotLook& look);

/// A ring around a point: the one in use, or the one that the keyboard is at.
void paintRing(QPainter& painter, const QPointF& at, double radius, const QColor& color);

/// One marker of a series.
void paintMarker(QPainter& painter,
                 const PlotSeries& series,
                 const QPointF& at,
                 double radius,
                 const PlotTheme& theme);

} // namespace trixel::ui
