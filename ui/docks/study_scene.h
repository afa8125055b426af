// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/filter/filter_scene.h"
#include "core/io/project.h"

#include <memory>

namespace trixel::ui {

/// What filters read of a project, for a study that runs on a snapshot of it. Takes both cores.
/// Fails only when cancelled.
Result<std::shared_ptr<const FilterScene>> studyScene(const Project& project, Progress& progress);

} // namespace trixel::ui
