// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/study/views/view_camera.h"
#include "render/camera.h"

namespace trixel::render {

/// The same view as core knows it: every pixel is looked through along the same ray.
ViewCamera viewOf(const Camera& camera);

/// Takes the place of the camera of a view: its position, direction and roll, its target as what
/// orbiting turns about. The whole picture of the view is seen, as large as it fits; a camera whose
/// viewport has the view's size sees exactly that picture. What is beyond the camera's range (see
/// `Camera::setPose`) comes as close as it gets.
/// \param view  valid (see `validate`)
void lookThrough(Camera& camera, const ViewCamera& view);

} // namespace trixel::render
