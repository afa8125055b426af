// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/parallel.h"
#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/io/project.h"

#include <string_view>

namespace trixel {

/// The scene that the window opens with, a chameleon on a twig: its control cage refined by Loop
/// subdivision, each face at a level that suits where it lies (finest about the eyes), and painted
/// by replaying recorded strokes. The same two files give the same texels, to the bit, whatever the
/// number of threads.
/// \param cageObj      resources/sample/chameleon.obj
/// \param strokesJson  resources/sample/chameleon.strokes.json
/// Errors name which of the two is damaged and where.
Result<Project> buildSampleScene(std::string_view cageObj,
                                 std::string_view strokesJson,
                                 Progress& progress,
                                 Threads threads = Threads::all());

} // namespace trixel
