// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/study/studies.h"
#include "app/cli/verb.h"

#include <CLI/CLI.hpp>

namespace trixel::app {
namespace {

constexpr AddVerb kStudies[] = {addSpeedAccuracy, addAuto, addSmallStudies, addSeams, addStability};

} // namespace

void addStudy(CLI::App& parser, Work& chosen)
{
    CLI::App* verb = parser.add_subcommand("study", "Measure methods and write tables and charts");
    verb->require_subcommand(1);
    verb->get_formatter()->label("SUBCOMMAND", "STUDY");
    for (const AddVerb add : kStudies) {
        add(*verb, chosen);
    }
    for (CLI::App* study : verb->get_subcommands([](CLI::App*) { return true; })) {
        study->group("Studies");
    }
    verb->footer(
        "Each writes NAME.csv and NAME.json into DIR, and NAME.svg and NAME.png where the\n"
        "program was built with its window.");
}

} // namespace trixel::app
