// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a chart shows, before anything is drawn: values, names, and which look belongs to whom.
#pragma once

#include <QString>

#include "ui/charts/quantity.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace trixel::ui {

/// A point with the values it is drawn at.
struct PlotPoint
{
    double x = 0;
    double y = 0;
    std::size_t source = 0; ///< what it shows: its number in the data the plot was made of
    QString tag;            ///< a few letters that tell it from its neighbours, "16"; may be empty
    bool onFront = false;
};

/// Points that belong together.
struct PlotSeries
{
    QString name;
    /// Which colour and which shape, the same for the same number wherever it appears.
    int look = 0;
    bool isPeer = false; ///< somebody else's work, for comparison: drawn grey and hollow
    std::vector<PlotPoint> points;
};

/// Whether a line joins the points in their order. A peer's are settings of several kinds, which
/// have none.
inline bool isCurve(const PlotSeries& series)
{
    return !series.isPeer && series.points.size() > 1;
}

struct PlotAxis
{
    QString title;
    Quantity quantity = Quantity::Number;
    double decades = 9; ///< that the axis spans at most
    /// Where these are given the axis is a list: a value is a position in it, evenly spaced.
    std::vector<QString> list = {};
};

/// A level that values are compared with: a tolerance, a bound.
struct PlotLevel
{
    double y = 0;
    QString name;
};

struct Plot
{
    QString title;
    QString subtitle; ///< what it was measured on
    QString note;     ///< what one needs to repeat it
    PlotAxis x;
    PlotAxis y;
    std::vector<PlotSeries> series;
    QString frontName; ///< of the line below all points; empty when there is none
    std::optional<PlotLevel> level;

    bool isEmpty() const { return series.empty(); }
};

/// One point of a plot.
struct PlotMark
{
    std::size_t series = 0;
    std::size_t point = 0;

    bool operator==(const PlotMark&) const = default;
};

inline const PlotPoint& pointOf(const Plot& plot, PlotMark mark)
{
    return plot.series[mark.series].points[mark.point];
}

/// The points of the front from left to right.
std::vector<PlotMark> frontOf(const Plot& plot);

} // namespace trixel::ui
