// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/cli/verb.h"

namespace trixel::app {

/// `trixel tour -o DIR`: the one verb that needs a display.
void addTour(CLI::App& parser, Work& chosen);

} // namespace trixel::app
