// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/display.h"

#include <cstdlib>

namespace trixel::app {

Status needDisplay()
{
    for (const char* variable : {"DISPLAY", "WAYLAND_DISPLAY", "QT_QPA_PLATFORM"}) {
        if (std::getenv(variable) != nullptr) {
            return {};
        }
    }
    return contentsError("trixel: there is no display to open a window on; the verbs but tour need "
                         "none ('trixel --help' lists them).");
}

} // namespace trixel::app
