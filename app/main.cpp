// SPDX-License-Identifier: GPL-3.0-or-later
#ifdef TRIXEL_HAS_WINDOW
#include "app/cli/study/studies.h"
#include "app/display.h"
#include "app/tour/verb.h"
#include "ui/charts/write_chart.h"
#include "ui/window/application.h"
#endif

#include "app/cli/command_line.h"

#include <csignal>

#ifdef TRIXEL_HAS_WINDOW
namespace {

/// For people and papers, and for where SVG is not taken.
trixel::Status writeCharts(const trixel::Study& study, const std::filesystem::path& folder)
{
    const std::string base = (folder / study.name).string();
    const trixel::Status svg = trixel::ui::writeChart(study, base + ".svg");
    return svg ? trixel::ui::writeChart(study, base + ".png") : svg;
}

} // namespace
#endif

int main(int argc, char** argv)
{
    using namespace trixel;
    // A write beyond the shell's limit on file sizes is then an error like any other, and what was
    // half written is removed.
    std::signal(SIGXFSZ, SIG_IGN);
#ifdef TRIXEL_HAS_WINDOW
    const app::OpenWindow openWindow = [&](const auto& file) {
        const Status display = app::needDisplay();
        return display ? ui::runWindow(argc, argv, file) : app::reportError(display.error());
    };
    app::setChartWriter(writeCharts);
    const app::AddVerb withDisplay[] = {app::addTour};
    return app::runCommandLine(argc, argv, withDisplay, openWindow);
#else
    return app::runCommandLine(argc, argv, {}, nullptr);
#endif
}
