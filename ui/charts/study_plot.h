// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStringList>

#include "core/study/study.h"
#include "ui/charts/plot.h"

#include <optional>
#include <vector>

namespace trixel::ui {

/// Which of a point's errors the chart shows.
enum class ErrorMeasure { Rms, P99 };

QString nameOf(ErrorMeasure measure);

/// What is chosen to be seen of a study.
struct StudyView
{
    std::optional<FootprintClass> footprintClass = {}; ///< nothing: all of them together
    ErrorMeasure measure = ErrorMeasure::Rms;
    std::optional<double> tolerance = {}; ///< a line across, in the error's unit

    bool operator==(const StudyView&) const = default;
};

/// The study as a plot of cost against error. Series keep the look of their method from one study
/// to the next. The front is that of the shown class and measure: nobody is cheaper and as
/// accurate. Where a study has methods, series without are peers. Points of which cost or error is
/// not a number are left out.
Plot plotOf(const Study& study, const StudyView& view);

/// The classes that the study has points of, "all together" (nothing) first.
std::vector<std::optional<FootprintClass>> classesOf(const Study& study);
/// "All footprints", "Small round", …
QString nameOf(const std::optional<FootprintClass>& footprintClass);

/// The point of a method with its parameter; without one, that of the method's standard.
std::optional<PlotMark> markOf(const Study& study, const Plot& plot, const MethodChoice& method);

/// The cheapest point that the view shows and whose error keeps the view's tolerance; peers do not
/// count. Nothing where nobody does, or without a tolerance.
std::optional<std::size_t> cheapestWithin(const Study& study, const StudyView& view);

/// A point in one line: who it is and what it costs.
QString inBrief(const Study& study, std::size_t point);

/// All that is known of a point, a few short lines: who it is, cost and errors, how measured.
QStringList describe(const Study& study, std::size_t point);

} // namespace trixel::ui
