// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/output.h"
#include "app/cli/study/studies.h"
#include "core/base/read_file.h"
#include "core/io/commit_file.h"

#include <iomanip>
#include <iostream>
#include <system_error>

namespace trixel::app {
namespace {

ChartWriter& chartWriter()
{
    static ChartWriter writer;
    return writer;
}

Status writeWhole(const std::filesystem::path& path, const std::string& text)
{
    return commitFile(
        path,
        [&](FileWriter& file) { return file.write(std::string_view(text)); },
        [&](const std::filesystem::path& written) -> Status {
            const auto found = readFile(written);
            if (!found) {
                return tl::unexpected(found.error());
            }
            return *found == text ? Status()
                                  : pathError("what was written does not read back the same.");
        });
}

Status makeFolder(const std::filesystem::path& folder)
{
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    return error ? pathError(folder.string() + ": " + error.message() + ".") : Status();
}

} // namespace

void setChartWriter(ChartWriter writer)
{
    chartWriter() = std::move(writer);
}

Status
writeText(const std::filesystem::path& folder, const std::string& name, const std::string& text)
{
    const Status made = makeFolder(folder);
    return made ? writeWhole(folder / name, text) : made;
}

Status writeStudy(const Study& study, const std::filesystem::path& folder)
{
    const std::filesystem::path base = folder / study.name;
    Status status = writeText(folder, study.name + ".csv", toCsv(study));
    status = status ? writeText(folder, study.name + ".json", toJson(study) + '\n') : status;
    if (!status) {
        return status;
    }
    std::cout << base.string() << ".csv, .json";
    if (!chartWriter()) {
        std::cout << " written; pictures need the build with the window.\n";
        return {};
    }
    status = chartWriter()(study, folder);
    if (status) {
        std::cout << ", .svg, .png written.\n";
    }
    return status;
}

void printStudy(const Study& study)
{
    std::size_t width = 20;
    for (const StudyPoint& point : study.points) {
        width = std::max(width, point.series.size() + point.variant.size() + 2);
    }
    std::cout << study.title << " (" << study.subject << ")\n"
              << study.conditions << '\n'
              << std::left << std::setw(static_cast<int>(width)) << "" << std::right
              << std::setw(12) << study.costUnit << std::setw(12) << "rms %" << std::setw(12)
              << "p99 %" << std::setw(12) << "worst %"
              << "  on the front\n";
    for (const StudyPoint& point : study.points) {
        if (point.footprintClass) {
            continue;
        }
        const std::string name = point.series + (point.variant.empty() ? "" : ", " + point.variant);
        std::cout << std::left << std::setw(static_cast<int>(width)) << name << std::right
                  << std::setprecision(4) << std::setw(12) << point.cost << std::setprecision(3)
                  << std::setw(12) << 100 * point.rms << std::setw(12) << 100 * point.p99
                  << std::setw(12) << 100 * point.worst << (point.onFront ? "  *" : "") << '\n';
    }
    for (const std::string& note : study.notes) {
        std::cout << note << '\n';
    }
}

} // namespace trixel::app
