// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/arguments.h"
#include "app/cli/output.h"
#include "app/cli/study/studies.h"
#include "core/study/speed/auto_method.h"

#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>

namespace trixel::app {
namespace {

struct Arguments
{
    std::string tolerance;
    bool anew = false;
    bool json = false;
};

nlohmann::json jsonOf(const AutoChoices& choices)
{
    nlohmann::json classes = nlohmann::json::array();
    for (const CostEntry& entry : choices.classes) {
        classes.push_back({{"class", nameOf(entry.footprintClass)},
                           {"method", toText(entry.method)},
                           {"cost", entry.cost},
                           {"rms", entry.rms}});
    }
    return {{"tolerance", choices.tolerance}, {"classes", std::move(classes)}};
}

Result<Outcome> showChoices(const Arguments& arguments, Progress& progress)
{
    const auto tolerance = positiveNumber("--tolerance", arguments.tolerance);
    if (!tolerance) {
        return tl::unexpected(tolerance.error());
    }
    const std::filesystem::path path = costTablePath();
    if (arguments.anew) {
        std::error_code ignored; // it is measured either way
        std::filesystem::remove(path, ignored);
    }
    const auto found = findCostTable(path, progress);
    if (!found) {
        return tl::unexpected(found.error());
    }
    const auto choices = chooseMethods(found->table, *tolerance);
    if (!choices) {
        return tl::unexpected(choices.error());
    }
    if (arguments.json) {
        printJson(jsonOf(*choices));
        return Outcome::Done;
    }
    std::cout << "On " << toText(found->table.machine)
              << (found->measured ? ", measured now: " + found->why : ", measured earlier") << ".\n"
              << toText(*choices);
    return Outcome::Done;
}

} // namespace

void addAuto(CLI::App& verb, Work& chosen)
{
    auto arguments = std::make_shared<Arguments>();
    CLI::App* name =
        verb.add_subcommand("auto", "Which method each class of footprint gets for a tolerance");
    name->add_option(
            "--tolerance", arguments->tolerance, "RMS error, a fraction of the value range")
        ->required()
        ->type_name("E");
    name->add_flag("--anew", arguments->anew, "Measure again what is kept of this machine");
    name->add_flag("--json", arguments->json, "Print one JSON object");
    name->callback([arguments, &chosen] {
        chosen = [arguments](Progress& progress) { return showChoices(*arguments, progress); };
    });
}

} // namespace trixel::app
