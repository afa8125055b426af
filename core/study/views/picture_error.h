// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/filter/filter_scene.h"
#include "core/study/views/view_queries.h"

namespace trixel {

/// How two pictures of one view differ, over the pixels that see the mesh.
struct PictureError
{
    double rms = 0;         ///< over pixels and channels, in the unit of the texel values
    double worst = 0;       ///< largest difference of one channel of one pixel
    std::size_t pixels = 0; ///< that see the mesh, among those asked
};

/// Renders the queries of a view through `exact` from both scenes, which stand on one surface and
/// have the same channels (checked). Fails only when cancelled.
Result<PictureError> pictureError(const FilterScene& before,
                                  const FilterScene& after,
                                  const FilterQueries& queries,
                                  Threads threads,
                                  Progress& progress);

} // namespace trixel
