// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/study/views/view_camera.h"

#include <glm/mat4x4.hpp>

namespace trixel {

/// From the world to the clip space of a camera: x to the right and y upwards from -1 to 1 over its
/// picture, w the distance along its view. Invertible. \param camera  valid (see `validate`)
glm::dmat4 toClip(const ViewCamera& camera);

} // namespace trixel
