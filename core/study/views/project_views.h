// SPDX-License-Identifier: GPL-3.0-or-later
//
// The views that are kept with a project.
#pragma once

#include "core/base/result.h"
#include "core/io/project.h"
#include "core/study/views/view_camera.h"

namespace trixel {

/// A project keeps no more views than this, cameras and distant ones together.
inline constexpr std::size_t kMostProjectViews = 1000;

/// The views that the project keeps; empty where it keeps none. Fails with a sentence where what it
/// keeps cannot be read: not the text of a cameras file, or more views than `kMostProjectViews`.
Result<SceneViews> viewsOf(const Project& project);

/// Keeps these views with the project in place of those before; empty ones leave nothing behind.
/// \param views  at most `kMostProjectViews`, each of them valid (see `validate`)
void keepViews(Project& project, const SceneViews& views);

} // namespace trixel
