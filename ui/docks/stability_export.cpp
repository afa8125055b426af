// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/docks/stability_export.h"

#include "core/study/stability/report_files.h"
#include "ui/charts/stability_plot.h"
#include "ui/charts/write_chart.h"

#include <algorithm>
#include <iterator>
#include <string_view>
#include <vector>

namespace trixel::ui {

namespace {

/// Of the sheet of all charts.
constexpr int kColumns = 3;
constexpr QSize kCell(560, 360);

} // namespace

bool isOfOneSweep(const ExportFormat& format)
{
    return std::string_view(format.command).starts_with("Chart shown");
}

Status writeStability(const StabilityReport& report,
                      const StabilitySweep& sweep,
                      const ExportFormat& format,
                      const std::filesystem::path& path)
{
    if (isOfOneSweep(format)) {
        return writePlot(plotOf(sweep), path);
    }
    const std::string_view ending = format.ending;
    if (ending == "svg") {
        std::vector<Plot> plots;
        std::ranges::transform(
            report.sweeps, std::back_inserter(plots), [](const auto& one) { return plotOf(one); });
        return writeSheet(plots, kColumns, path, {.size = kCell});
    }
    return writeText(path, ending == "csv" ? toCsv(report) : toJson(report));
}

} // namespace trixel::ui
