// SPDX-License-Identifier: GPL-3.0-or-later
//
// A picture as queries: what each pixel of a view that sees the mesh averages.
#pragma once

#include "core/base/parallel.h"
#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/filter/filter_queries.h"
#include "core/mesh/limit_mesh.h"
#include "core/mesh/surface.h"
#include "core/study/views/view_camera.h"

#include <cstdint>
#include <vector>

namespace trixel {

/// Which pixels of a picture stand for all: one of each block of step × step, at a place within the
/// block that is as good as random but always the same. Step 1 takes every pixel.
struct PixelSubset
{
    int step = 1;           ///< at least 1 (checked)
    std::uint32_t seed = 0; ///< another choice within the blocks
};

/// The pixels that see the mesh, in the order of rows, with the footprint of each.
struct ViewQueries
{
    std::vector<std::uint32_t> pixel; ///< x + y · width
    QueryArrays queries;
    /// Pixels that were asked, whether or not they see the mesh.
    std::size_t asked = 0;

    std::size_t size() const { return pixel.size(); }
};

/// Sends a ray through the centre of every pixel of the subset. The answer does not depend on the
/// number of threads. Fails only when cancelled.
/// \param camera  valid (see `validate`)
Result<ViewQueries> viewQueries(const Surface& surface,
                                const ViewCamera& camera,
                                PixelSubset subset,
                                Threads threads,
                                Progress& progress);

/// The same of a limit surface: the points are its own, the footprints those of its derivatives.
Result<ViewQueries> viewQueries(const LimitMesh& limit,
                                const ViewCamera& camera,
                                PixelSubset subset,
                                Threads threads,
                                Progress& progress);

/// Whether every point that the picture shows is seen by one of `views` too (see `sees`; those of a
/// distance see every point), and there no farther (in no more world units a pixel). Judged at the
/// pixels of the subset.
bool isCovered(const Surface& surface,
               const SceneViews& views,
               const ViewCamera& camera,
               PixelSubset subset);

} // namespace trixel
