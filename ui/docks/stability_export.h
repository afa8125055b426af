// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "core/study/stability/stability.h"
#include "ui/docks/chart_export.h"

#include <filesystem>

namespace trixel::ui {

inline constexpr ExportFormat kStabilityFormats[] = {
    {"Chart shown (&SVG)…", "Scalable pictures (*.svg)", "svg"},
    {"Chart shown (&PNG)…", "Pictures (*.png)", "png"},
    {"Sheet of &all charts (SVG)…", "Scalable pictures, all charts (*.svg)", "svg"},
    {"Table (&CSV)…", "Tables (*.csv)", "csv"},
    {"All that was swept (&JSON)…", "JSON (*.json)", "json"}};

/// Whether a format shows the chosen sweep rather than the whole report.
bool isOfOneSweep(const ExportFormat& format);

/// Writes the report, or one sweep of it, as the format says; the file is whole or not there.
Status writeStability(const StabilityReport& report,
                      const StabilitySweep& sweep,
                      const ExportFormat& format,
                      const std::filesystem::path& path);

} // namespace trixel::ui
