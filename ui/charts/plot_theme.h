// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <QFont>
#include <QPainterPath>

namespace trixel::ui {

/// The colours of a plot, but for those of its series.
struct PlotTheme
{
    QColor background;
    QColor text;
    QColor faint; ///< ticks, notes, peers
    QColor grid;
    QColor fineGrid;
    QColor front;
    QColor level;
    bool isDark = false;
};

/// For paper and light windows, on white.
PlotTheme lightPlotTheme();
PlotTheme darkPlotTheme();

/// How a series looks: seven colours that people of any colour vision tell apart, times nine
/// shapes; no two of the first 63 looks are equal. Colours: M. Okabe and K. Ito, "Color Universal
/// Design" (2002), without their yellow, which cannot be read on white.
QColor colorOf(int look, const PlotTheme& theme);
/// Around the origin, about as large as a circle of radius 1.
QPainterPath shapeOf(int look);

/// The sizes of writing in a plot.
struct PlotFonts
{
    QFont title;
    QFont text;  ///< names, axes
    QFont small; ///< ticks, notes, tags

    explicit PlotFonts(const QFont& base);
};

} // namespace trixel::ui
