// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/file_kind.h"
#include "app/cli/output.h"
#include "app/cli/verb.h"
#include "core/io/ptx_rematch.h"
#include "core/mesh/mesh_reader.h"

#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>

namespace trixel::app {
namespace {

struct Arguments
{
    std::string input;
    std::string mesh;
    std::string output;
};

/// Of a mesh file, or what a project or .ptx carries.
Result<std::shared_ptr<const Surface>> surfaceOf(const std::string& path, Progress& progress)
{
    const auto kind = expectFileKind(path);
    if (!kind) {
        return tl::unexpected(kind.error());
    }
    if (*kind != FileKind::Mesh) {
        return openPainted(path, progress).map([](const Project& project) {
            return project.surface;
        });
    }
    StageProgress reading(progress, 0, 0.5);
    auto mesh = readMesh(path, reading);
    if (!mesh) {
        return tl::unexpected(mesh.error());
    }
    StageProgress building(progress, 0.5, 1);
    return Surface::build(std::move(*mesh), building);
}

Result<Outcome> match(const Arguments& arguments, Progress& progress)
{
    for (const std::string& name : {arguments.input, arguments.output}) {
        if (const Status ending = expectEnding(name, FileKind::Ptx); !ending) {
            return tl::unexpected(ending.error());
        }
    }
    StageProgress reading(progress, 0, 0.3);
    auto surface = surfaceOf(arguments.mesh, reading);
    if (!surface) {
        return tl::unexpected(surface.error());
    }
    StageProgress matching(progress, 0.3, 0.7);
    const auto matched = openPtxMatched(arguments.input, std::move(*surface), matching);
    if (!matched) {
        return tl::unexpected(matched.error());
    }
    StageProgress writing(progress, 0.7, 1);
    const Status written =
        exportPtx(arguments.output, matched->project, {.mips = matched->hasMips}, writing);
    if (!written) {
        return tl::unexpected(written.error());
    }
    std::printf("%s: %s\n", arguments.input.c_str(), matched->match.describe().c_str());
    return Outcome::Done;
}

} // namespace

void addMatch(CLI::App& parser, Work& chosen)
{
    auto arguments = std::make_shared<Arguments>();
    CLI::App* verb = parser.add_subcommand(
        "match", "Reorder and rewind the faces of a .ptx so that they are a mesh's");
    verb->add_option("IN", arguments->input, "File to read (.ptx)")->required()->type_name("FILE");
    verb->add_option("--mesh",
                     arguments->mesh,
                     "Mesh of the same faces, or a project or .ptx that carries it")
        ->required()
        ->type_name("FILE");
    verb->add_option("-o,--output", arguments->output, "File to write (.ptx)")
        ->required()
        ->type_name("FILE");
    verb->footer("Faces are found by the vertex positions that the .ptx carries, else by who\n"
                 "neighbours whom. Texels keep their bytes; IN may be OUT.");
    verb->callback([arguments, &chosen] {
        chosen = [arguments](Progress& progress) { return match(*arguments, progress); };
    });
}

} // namespace trixel::app
