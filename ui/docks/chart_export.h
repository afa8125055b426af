// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <functional>
#include <span>

class QMenu;
class QWidget;

namespace trixel::ui {

/// A kind of file that a study is written as.
struct ExportFormat
{
    const char* command; ///< with its mnemonic
    const char* filter;  ///< of the file dialog
    const char* ending;
};

inline constexpr ExportFormat kChartFormats[] = {
    {"Picture for paper and web (&SVG)…", "Scalable pictures (*.svg)", "svg"},
    {"Picture in pixels (&PNG)…", "Pictures (*.png)", "png"},
    {"Table (&CSV)…", "Tables (*.csv)", "csv"},
    {"All that was measured (&JSON)…", "JSON (*.json)", "json"}};

/// A menu with one command a format.
QMenu* makeExportMenu(std::span<const ExportFormat> formats,
                      QWidget& parent,
                      std::function<void(const ExportFormat&)> chosen);

/// Asks for a file in the folder that was written to last; a name without an ending gets the
/// format's.
void askForExport(const ExportFormat& format,
                  const QString& name,
                  QWidget& parent,
                  std::function<void(const QString& path)> then);

} // namespace trixel::ui
