// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/arguments.h"
#include "app/cli/file_kind.h"
#include "app/cli/verb.h"
#include "core/base/read_file.h"
#include "core/io/new_project.h"
#include "core/paint/stroke_file.h"

#include <CLI/CLI.hpp>
#include <memory>
#include <optional>
#include <utility>

namespace trixel::app {
namespace {

struct Arguments
{
    std::string project;
    std::string strokes;
    std::string output;
    std::optional<std::string> threads;
};

Result<std::vector<RecordedStroke>> readStrokes(const std::filesystem::path& path,
                                                std::size_t faceCount)
{
    const auto text = readFile(path);
    if (!text) {
        return tl::unexpected(text.error());
    }
    auto strokes = parseStrokes(*text, faceCount);
    if (!strokes) {
        return prefixed(path.string(), strokes.error());
    }
    return strokes;
}

Result<Outcome> paint(const Arguments& arguments, Progress& progress)
{
    if (const Status ending = expectEnding(arguments.output, FileKind::Project); !ending) {
        return tl::unexpected(ending.error());
    }
    const auto count = threads("--threads", arguments.threads);
    if (!count) {
        return tl::unexpected(count.error());
    }
    StageProgress opening(progress, 0, 0.2);
    auto project = openPainted(arguments.project, opening);
    if (!project) {
        return tl::unexpected(project.error());
    }
    const auto strokes = readStrokes(arguments.strokes, project->texels.faceCount());
    if (!strokes) {
        return tl::unexpected(strokes.error());
    }
    StageProgress painting(progress, 0.2, 0.8);
    const std::vector<std::byte> fill = fillOf(*project);
    Layered layered{std::move(project->texels), std::move(project->layers)};
    const Status painted = replayStrokes(
        *strokes, project->surface, fill, layered, *count, painting, project->creaseAngle);
    if (!painted) {
        return tl::unexpected(painted.error());
    }
    project->texels = std::move(layered.shown);
    project->layers = std::move(layered.layers);
    StageProgress saving(progress, 0.8, 1);
    return saveProject(arguments.output, *project, saving).map([] { return Outcome::Done; });
}

} // namespace

void addPaint(CLI::App& parser, Work& chosen)
{
    auto arguments = std::make_shared<Arguments>();
    CLI::App* verb = parser.add_subcommand("paint", "Replay recorded strokes on a project");
    verb->add_option("PROJECT", arguments->project, "Project, or .ptx that carries its mesh")
        ->required()
        ->type_name("FILE");
    verb->add_option("--strokes", arguments->strokes, "Stroke file (JSON)")
        ->required()
        ->type_name("FILE");
    verb->add_option("-o,--output", arguments->output, "Project to write (.trixel)")
        ->required()
        ->type_name("FILE");
    verb->add_option("--threads",
                     arguments->threads,
                     "Threads to use, all cores by default; the result is the same")
        ->type_name("N");
    verb->callback([arguments, &chosen] {
        chosen = [arguments](Progress& progress) { return paint(*arguments, progress); };
    });
}

} // namespace trixel::app
