// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QRectF>
#include <QSizeF>

#include "ui/charts/list_axis.h"
#include "ui/charts/log_axis.h"
#include "ui/charts/plot.h"
#include "ui/charts/plot_theme.h"

#include <optional>
#include <vector>

namespace trixel::ui {

/// What is written besides the plot itself; a panel has places of its own for it.
struct PlotParts
{
    bool heading = true; ///< title and what was measured
    bool note = true;    ///< what one needs to repeat it
};

struct LegendEntry
{
    QRectF box;
    std::optional<std::size_t> series; ///< nothing: the front
};

/// A name beside its curve, or the tag of a point.
struct PlacedLabel
{
    QRectF box;
    QString text;
    std::size_t series = 0;
    bool isTag = false;
};

/// Where everything in a plot lies, in the units of its size. Nothing is drawn; the same serves
/// window, picture and paper.
struct PlotLayout
{
    QSizeF size;
    double edge = 10; ///< free rim around everything
    QRectF heading;
    QRectF note;
    QRectF frame; ///< of the axes
    LogAxis xAxis;
    std::optional<ListAxis> xList; ///< in place of `xAxis`
    LogAxis yAxis;
    std::vector<Tick> xTicks;
    std::vector<Tick> yTicks;
    double markRadius = 4.2;
    double lineWidth = 1.5;
    std::vector<LegendEntry> legend;
    std::vector<PlacedLabel> labels;
    QRectF levelName;

    double xAt(double value) const
    {
        return frame.left() + frame.width() * (xList ? xList->place(value) : xAxis.place(value));
    }
    double yAt(double value) const { return frame.bottom() - frame.height() * yAxis.place(value); }
    QPointF at(const PlotPoint& point) const { return {xAt(point.x), yAt(point.y)}; }
};

/// Names are placed where they cover neither a point nor each other; one that finds no such place
/// is left to the legend.
PlotLayout
layOut(const Plot& plot, const QSizeF& size, const PlotFonts& fonts, const PlotParts& parts);

/// The point nearest to a position, if one lies within reach.
std::optional<PlotMark>
markAt(const Plot& plot, const PlotLayout& layout, const QPointF& position, double reach);

/// The legend's entry at a position.
std::optional<std::size_t> legendSeriesAt(const PlotLayout& layout, const QPointF& position);

/// The line from the top along the front to the right: nothing lies below it.
QPolygonF frontLine(const Plot& plot, const PlotLayout& layout);

} // namespace trixel::ui
