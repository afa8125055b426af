// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/io/project.h"

#include <string>

namespace trixel::app {

/// Makes a project look like texels that were made from what it shows: they take the place of what
/// was shown, or, where there are layers, what differs becomes one more on top.
/// \param painted  of the project's format, faces and levels
/// \param name     of the layer
Status takePaint(Project& project, TexelStore painted, std::string name, Progress& progress);

} // namespace trixel::app
