// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"

namespace trixel::app {

/// Fails with a sentence where the environment names no display to open a window on: Qt would end
/// the program there.
Status needDisplay();

} // namespace trixel::app
