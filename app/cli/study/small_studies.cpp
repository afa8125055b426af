// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/small_studies.h"

#include "app/cli/study/studies.h"
#include "core/mesh/mesh_reader.h"

#include <CLI/CLI.hpp>
#include <memory>
#include <optional>

namespace trixel::app {
namespace {

struct Arguments
{
    std::optional<std::string> file;
    std::string output;
};

using Measure = Result<Study> (*)(StudyWatcher&);

Result<Outcome> finish(const Result<Study>& study, const std::string& folder)
{
    if (!study) {
        return tl::unexpected(study.error());
    }
    printStudy(*study);
    return writeStudy(*study, folder).map([] { return Outcome::Done; });
}

void addSmall(CLI::App& verb, Work& chosen, const char* name, const char* about, Measure measure)
{
    auto arguments = std::make_shared<Arguments>();
    CLI::App* study = verb.add_subcommand(name, about);
    study->add_option("-o,--output", arguments->output, "Folder to write into")
        ->required()
        ->type_name("DIR");
    study->callback([arguments, measure, &chosen] {
        chosen = [arguments, measure](Progress& progress) {
            UnwatchedPoints watcher(progress);
            return finish(measure(watcher), arguments->output);
        };
    });
}

Result<Outcome> subdivide(const Arguments& arguments, Progress& progress)
{
    StageProgress reading(progress, 0, 0.1);
    const auto cage = arguments.file ? readMesh(*arguments.file, reading) : storedCage();
    if (!cage) {
        return tl::unexpected(cage.error());
    }
    StageProgress measuring(progress, 0.1, 1);
    UnwatchedPoints watcher(measuring);
    const auto study = studySubdivision(*cage, watcher);
    if (!study && arguments.file) {
        return prefixed(*arguments.file, study.error());
    }
    return finish(study, arguments.output);
}

} // namespace

void addSmallStudies(CLI::App& verb, Work& chosen)
{
    addSmall(verb,
             chosen,
             "paint-projection",
             "Painting the packed square: offset 1/6 against none",
             studyPaintProjection);
    addSmall(verb,
             chosen,
             "reduction",
             "Halving the resolution: our rule against the 2x2 box",
             studyReduction);
    addSmall(verb, chosen, "storage", "Types of texels: memory against error", studyStorage);
    auto arguments = std::make_shared<Arguments>();
    CLI::App* study = verb.add_subcommand(
        "subdivision", "Loop subdivision: faces against distance from the limit");
    study->add_option("MESH", arguments->file, "Control cage; without it, the sample scene's")
        ->type_name("FILE");
    study->add_option("-o,--output", arguments->output, "Folder to write into")
        ->required()
        ->type_name("DIR");
    study->callback([arguments, &chosen] {
        chosen = [arguments](Progress& progress) { return subdivide(*arguments, progress); };
    });
}

} // namespace trixel::app
