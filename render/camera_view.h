// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/study/view_camera.h"
#include "render/camera.h"

namespace trixel::render {

/// The same view as core knows it: every pixel is looked through along the same ray.
ViewCamera viewOf(const Camera& camera);

} // namespace trixel::render
