// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/filter/filter_method.h"
#include "core/mesh/surface.h"
#include "core/study/views/view_camera.h"

#include <optional>

namespace trixel {

/// A method as the pictures of a scene need it.
struct FitMethod
{
    MethodChoice method;
    double nanoseconds = 0; ///< processor time a pixel, here and now
    double rms = 0;         ///< against `exact`, over the pixels of all cameras
    std::size_t pixels = 0;
};

/// The method of the table, at a parameter of its curve, that costs least and whose pictures from
/// the listed cameras are within the tolerance of `exact`; measured on up to about 2,000 pixels a
/// camera. Nothing where no camera sees the mesh, or none is good enough (but `exact`). Fails only
/// when cancelled.
/// \param tolerance  RMS, in the unit of the texel values
Result<std::optional<FitMethod>> fitMethod(const Surface& surface,
                                           const FilterScene& scene,
                                           const SceneViews& views,
                                           double tolerance,
                                           Threads threads,
                                           Progress& progress);

} // namespace trixel
