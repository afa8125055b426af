// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QSize>

#include "core/base/result.h"
#include "core/study/study.h"
#include "ui/charts/plot_painter.h"
#include "ui/charts/study_plot.h"

#include <filesystem>
#include <span>
#include <string_view>

namespace trixel::ui {

struct ChartOptions
{
    StudyView view = {};
    std::optional<MethodChoice> chosen = {}; ///< ringed where it is among the points
    QSize size{960, 640};                    ///< of an SVG, in units of 1/96 inch
    double pixelsPerUnit = 2; ///< of a PNG: as sharp as a screen of twice the density
    bool dark = false;
};

/// Writes a study as its ending says: `.svg` and `.png` the chart, `.csv` and `.json` the points.
/// The file is whole or not there. Needs no display and, where the program has none yet, brings an
/// application of its own for the time of the call; then call it from the main thread.
/// Errors: another ending, a class the study has no points of (Contents); the file (Path).
Status
writeChart(const Study& study, const std::filesystem::path& path, const ChartOptions& options = {});

/// The same for any plot, as `.svg` or `.png`.
Status
writePlot(const Plot& plot, const std::filesystem::path& path, const ChartOptions& options = {});

/// Several plots on one sheet, row by row, as `.svg` or `.png`. `size` is that of each; notes are
/// left out.
/// \param plots  at least one (Contents error else)
Status writeSheet(std::span<const Plot> plots,
                  int columns,
                  const std::filesystem::path& path,
                  const ChartOptions& options);

/// Writes a text that is there already; the file is whole or not there.
Status writeText(const std::filesystem::path& path, std::string_view text);

} // namespace trixel::ui
