// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/file_kind.h"
#include "app/cli/verb.h"

#include <CLI/CLI.hpp>
#include <memory>

namespace trixel::app {
namespace {

struct Arguments
{
    std::string project;
    std::string output;
};

Result<Outcome> exportProject(const Arguments& arguments, Progress& progress)
{
    if (const Status ending = expectEnding(arguments.output, FileKind::Ptx); !ending) {
        return tl::unexpected(ending.error());
    }
    StageProgress opening(progress, 0, 0.3);
    const auto project = openPainted(arguments.project, opening);
    if (!project) {
        return tl::unexpected(project.error());
    }
    StageProgress writing(progress, 0.3, 1);
    return exportPtx(arguments.output, *project, PtxWriteOptions{}, writing).map([] {
        return Outcome::Done;
    });
}

} // namespace

void addExport(CLI::App& parser, Work& chosen)
{
    auto arguments = std::make_shared<Arguments>();
    CLI::App* verb = parser.add_subcommand("export", "Write a project as .ptx");
    verb->add_option("PROJECT", arguments->project, "Project, or .ptx that carries its mesh")
        ->required()
        ->type_name("FILE");
    verb->add_option("-o,--output", arguments->output, "File to write (.ptx)")
        ->required()
        ->type_name("FILE");
    verb->callback([arguments, &chosen] {
        chosen = [arguments](Progress& progress) { return exportProject(*arguments, progress); };
    });
}

} // namespace trixel::app
