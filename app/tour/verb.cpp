// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/tour/verb.h"

#include "app/display.h"
#include "app/tour/tour.h"

#include <CLI/CLI.hpp>
#include <memory>
#include <string>

namespace trixel::app {

void addTour(CLI::App& parser, Work& chosen)
{
    const auto folder = std::make_shared<std::string>();
    CLI::App* verb = parser.add_subcommand(
        "tour", "Use the window by itself on the sample scene; save pictures and an export");
    verb->add_option("-o,--output", *folder, "Folder for pictures and export, made if missing")
        ->required()
        ->type_name("DIR");
    verb->callback([folder, &chosen] {
        chosen = [folder](Progress& /*progress*/) -> Result<Outcome> {
            return needDisplay().and_then([&] { return takeTour(*folder); }).map([] {
                return Outcome::Done;
            });
        };
    });
}

} // namespace trixel::app
