// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/file_summary.h"
#include "app/cli/output.h"
#include "app/cli/verb.h"

#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>

namespace trixel::app {
namespace {

struct Arguments
{
    std::string file;
    bool json = false;
};

Result<Outcome> info(const Arguments& arguments, Progress& progress)
{
    const auto summary = summarise(arguments.file, progress);
    if (!summary) {
        return tl::unexpected(summary.error());
    }
    if (arguments.json) {
        printJson(toJson(*summary));
    } else {
        std::cout << toText(*summary);
    }
    return Outcome::Done;
}

} // namespace

void addInfo(CLI::App& parser, Work& chosen)
{
    auto arguments = std::make_shared<Arguments>();
    CLI::App* verb = parser.add_subcommand("info", "Tell what a mesh, .ptx or project holds");
    verb->add_option("FILE", arguments->file, "Mesh, .ptx or .trixel project")
        ->required()
        ->type_name("FILE");
    verb->add_flag("--json", arguments->json, "Print one JSON object");
    verb->callback([arguments, &chosen] {
        chosen = [arguments](Progress& progress) { return info(*arguments, progress); };
    });
}

} // namespace trixel::app
