// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/stability/stability.h"

#include "app/cli/filter_input.h"
#include "app/cli/study/studies.h"
#include "core/study/stability/report_files.h"

#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>
#include <optional>

namespace trixel::app {
namespace {

struct Arguments
{
    std::optional<std::string> file;
    std::optional<std::string> mesh;
    std::string output;
};

/// Progress that hears of sweeps and does nothing with them.
class UnwatchedSweeps final : public StabilityWatcher
{
public:
    explicit UnwatchedSweeps(Progress& progress)
        : m_progress(progress)
    {
    }
    bool report(double fraction) override { return m_progress.report(fraction); }
    void swept(const StabilitySweep& /*sweep*/) override {}

private:
    Progress& m_progress;
};

Result<StabilityReport> sweepsAlone(Progress& progress)
{
    UnwatchedSweeps watcher(progress);
    return runStability(nullptr, Threads::all(), watcher);
}

Result<StabilityReport> sweepsAndAsset(const Arguments& arguments, Progress& progress)
{
    StageProgress opening(progress, 0, 0.5);
    const auto input = openFilterInput(*arguments.file, arguments.mesh, opening);
    if (!input) {
        return tl::unexpected(input.error());
    }
    StageProgress sweeping(progress, 0.5, 1);
    UnwatchedSweeps watcher(sweeping);
    const StabilityAsset asset{std::filesystem::path(*arguments.file).filename().string(),
                               *input->scene,
                               input->mesh ? &*input->mesh : nullptr};
    return runStability(&asset, Threads::all(), watcher);
}

Status write(const StabilityReport& report, const std::filesystem::path& folder)
{
    Status status = writeText(folder, "stability.csv", toCsv(report));
    status = status ? writeText(folder, "stability.json", toJson(report)) : status;
    return status ? writeText(folder, "stability.svg", toSvg(report)) : status;
}

Result<Outcome> study(const Arguments& arguments, Progress& progress)
{
    const auto report =
        arguments.file ? sweepsAndAsset(arguments, progress) : sweepsAlone(progress);
    if (!report) {
        return tl::unexpected(report.error());
    }
    const std::filesystem::path folder = arguments.output;
    if (const Status written = write(*report, folder); !written) {
        return tl::unexpected(written.error());
    }
    std::cout << toText(*report) << (folder / "stability").string()
              << ".csv, .json, .svg written.\n";
    return report->holds() ? Outcome::Done : Outcome::FaultsFound;
}

} // namespace

void addStability(CLI::App& verb, Work& chosen)
{
    auto arguments = std::make_shared<Arguments>();
    CLI::App* name =
        verb.add_subcommand("stability", "Every hazard: the textbook's formula beside ours");
    name->add_option(
            "FILE", arguments->file, "Project, .ptx or mesh whose own faces to look at besides")
        ->type_name("FILE");
    name->add_option("-o,--output", arguments->output, "Folder to write into")
        ->required()
        ->type_name("DIR");
    name->add_option("--mesh", arguments->mesh, "Mesh to put a .ptx on")->type_name("FILE");
    name->footer("Exit status 1 says that one of our own formulas broke its bound.");
    name->callback([arguments, &chosen] {
        chosen = [arguments](Progress& progress) { return study(*arguments, progress); };
    });
}

} // namespace trixel::app
