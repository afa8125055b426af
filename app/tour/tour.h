// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"

#include <filesystem>

namespace trixel::app {

/// Opens the window on the sample scene and uses it as a person would, with real pointer and key
/// events: looks around, reads a texel, paints, undoes, shows mips, starts a project, exports.
/// Writes a numbered picture of each step, and the exported `.ptx`, to a folder (made if missing).
/// Needs a display with OpenGL.
/// Errors name the stop that did not do what it should, or the file that could not be written.
Status takeTour(const std::filesystem::path& folder);

} // namespace trixel::app
