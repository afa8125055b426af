// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/surface.h"
#include "core/study/seam_meter.h"
#include "core/study/views/view_camera.h"

#include <memory>

namespace trixel {

/// The footprint that the pixel of a view which shows a point has there; nothing where the point is
/// outside the picture or hidden. May be called from several threads.
/// \param camera  valid (see `validate`)
FootprintAt footprintsOf(std::shared_ptr<const Surface> surface, const ViewCamera& camera);

} // namespace trixel
