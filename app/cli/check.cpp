// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/file_kind.h"
#include "app/cli/output.h"
#include "app/cli/verb.h"
#include "core/io/ptx_check.h"
#include "core/mesh/mesh_reader.h"
#include "core/mesh/surface.h"

#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>

namespace trixel::app {
namespace {

struct Arguments
{
    std::string file;
    std::optional<std::string> mesh;
    bool json = false;
};

using Faults = std::vector<std::string>;

Result<Faults> faultsOfMesh(const Arguments& arguments, Progress& progress)
{
    if (arguments.mesh) {
        return contentsError("--mesh: " + arguments.file +
                             " is a mesh itself; only a .ptx is compared with one.");
    }
    StageProgress reading(progress, 0, 0.5);
    auto mesh = readMesh(arguments.file, reading);
    if (!mesh) {
        return tl::unexpected(mesh.error());
    }
    StageProgress building(progress, 0.5, 1);
    return Surface::build(std::move(*mesh), building).map([](const auto& surface) {
        const MeshReport& report = surface->report();
        return report.isClean() ? Faults{} : report.describe();
    });
}

/// Of a project, too: it is a .ptx with more metadata.
Result<Faults> faultsOfPtx(const Arguments& arguments, Progress& progress)
{
    if (!arguments.mesh) {
        return checkPtx(arguments.file, {}, progress);
    }
    StageProgress reading(progress, 0, 0.3);
    const auto mesh = readMesh(*arguments.mesh, reading);
    if (!mesh) {
        return tl::unexpected(mesh.error());
    }
    PtxCheckOptions options;
    options.mesh = &*mesh;
    StageProgress checking(progress, 0.3, 1);
    return checkPtx(arguments.file, options, checking);
}

Result<Outcome> checkFile(const Arguments& arguments, Progress& progress)
{
    const auto kind = expectFileKind(arguments.file);
    if (!kind) {
        return tl::unexpected(kind.error());
    }
    const auto faults = *kind == FileKind::Mesh ? faultsOfMesh(arguments, progress)
                                                : faultsOfPtx(arguments, progress);
    if (!faults) {
        return tl::unexpected(faults.error());
    }
    if (arguments.json) {
        printJson({{"file", arguments.file}, {"faults", *faults}});
    } else {
        for (const std::string& fault : *faults) {
            std::cout << fault << '\n';
        }
        if (faults->empty()) {
            std::cout << "No faults.\n";
        }
    }
    return faults->empty() ? Outcome::Done : Outcome::FaultsFound;
}

} // namespace

void addCheck(CLI::App& parser, Work& chosen)
{
    auto arguments = std::make_shared<Arguments>();
    CLI::App* verb = parser.add_subcommand("check", "Look for faults in a mesh, .ptx or project");
    verb->add_option("FILE", arguments->file, "Mesh, .ptx or .trixel project")
        ->required()
        ->type_name("FILE");
    verb->add_option("--mesh",
                     arguments->mesh,
                     "Mesh to compare a .ptx with: order and winding of faces, adjacency")
        ->type_name("FILE");
    verb->add_flag("--json", arguments->json, "Print one JSON object");
    verb->footer("Exit status 1 says that faults were found.");
    verb->callback([arguments, &chosen] {
        chosen = [arguments](Progress& progress) { return checkFile(*arguments, progress); };
    });
}

} // namespace trixel::app
