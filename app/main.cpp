// SPDX-License-Identifier: GPL-3.0-or-later
#ifdef TRIXEL_HAS_WINDOW
#include "app/tour/verb.h"
#include "ui/window/application.h"
#endif

#include "app/cli/command_line.h"

#include <csignal>
#include <cstdlib>

#ifdef TRIXEL_HAS_WINDOW
namespace {

/// Without one Qt would abort.
bool hasDisplay()
{
    return std::getenv("DISPLAY") != nullptr || std::getenv("WAYLAND_DISPLAY") != nullptr ||
           std::getenv("QT_QPA_PLATFORM") != nullptr;
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
        return hasDisplay()
                   ? ui::runWindow(argc, argv, file)
                   : app::reportError({ErrorKind::Contents,
                                       "trixel: there is no display to open a window on; the "
                                       "verbs need none ('trixel --help' lists them)."});
    };
    const app::AddVerb withDisplay[] = {app::addTour};
    return app::runCommandLine(argc, argv, withDisplay, openWindow);
#else
    return app::runCommandLine(argc, argv, {}, nullptr);
#endif
}
