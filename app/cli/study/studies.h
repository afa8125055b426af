// SPDX-License-Identifier: GPL-3.0-or-later
//
// `trixel study NAME`: one file a study.
#pragma once

#include "app/cli/verb.h"
#include "core/study/study.h"

#include <filesystem>
#include <functional>
#include <string>

namespace trixel::app {

/// Makes one study known below the verb, as AddVerb does.
void addSpeedAccuracy(CLI::App& verb, Work& chosen);
void addSeams(CLI::App& verb, Work& chosen);
void addAuto(CLI::App& verb, Work& chosen);
void addStability(CLI::App& verb, Work& chosen);
/// paint-projection, reduction, storage and subdivision.
void addSmallStudies(CLI::App& verb, Work& chosen);

/// Draws a study's chart into the folder, as NAME.svg and NAME.png. Only the build with the window
/// can; see `setChartWriter`.
using ChartWriter = std::function<Status(const Study&, const std::filesystem::path& folder)>;
/// To be called before the command line runs.
void setChartWriter(ChartWriter writer);

/// Writes NAME.csv and NAME.json into the folder, which is made if missing, and the chart where
/// this build can draw; prints what was written.
Status writeStudy(const Study& study, const std::filesystem::path& folder);

/// Writes a text file, whole or not at all, into the folder, which is made if missing.
Status
writeText(const std::filesystem::path& folder, const std::string& name, const std::string& text);

/// Prints the points of all classes together as a table, those on the front marked, then notes.
void printStudy(const Study& study);

/// Progress that hears of points and does nothing with them.
class UnwatchedPoints final : public StudyWatcher
{
public:
    explicit UnwatchedPoints(Progress& progress)
        : m_progress(progress)
    {
    }
    bool report(double fraction) override { return m_progress.report(fraction); }
    void measured(const StudyPoint& /*point*/) override {}

private:
    Progress& m_progress;
};

} // namespace trixel::app
