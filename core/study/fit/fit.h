// SPDX-License-Identifier: GPL-3.0-or-later
//
// Fit to scene: the lowest level per face that keeps what a scene's cameras, and every view they
// cover, can see of the texture.
#pragma once

#include "core/base/face_map.h"
#include "core/base/parallel.h"
#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/mesh/surface.h"
#include "core/study/fit/face_views.h"
#include "core/texture/level_change.h"
#include "core/texture/texel_patch.h"

#include <cstdint>

namespace trixel {

/// Pixels of the mesh that a picture must show for the promise to hold for it: a mean over fewer
/// hangs on too few faces.
inline constexpr std::uint32_t kFewestPixels = 4096;

struct FitSettings
{
    SceneViews views;
    /// RMS over a picture's pixels that see the mesh and over all channels, before against after,
    /// both through `exact`; in the unit of the texel values (integers: [0,1]).
    double tolerance = 1.0 / 255;
    UnseenFaces unseen = UnseenFaces::OneTexel;
};

/// What would be done, and how it was measured.
struct FitPlan
{
    FaceMap<Level> levels;
    /// RMS of each face at the finest footprint that a covered view can have there; NaN where it is
    /// not judged.
    FaceMap<float> errors;
    LevelCost cost;
    double rms = 0;       ///< over all judged faces, by pixels
    double worstPart = 0; ///< RMS of the worst patch of about 2,048 pixels
    double worstFace = 0;
    std::uint32_t unseenFaces = 0;        ///< no view sees them
    std::uint64_t unseenTexelsBefore = 0; ///< of those faces
    std::uint64_t unseenTexelsAfter = 0;

    /// The faces that change, at their new levels, and those beside them that keep theirs but have
    /// their texels moved: a coarser neighbour lets the filter blur them more.
    TexelPatch fitted;
};

/// Lowers the levels of faces as far as the tolerance lets it; never raises one. Judged by `exact`
/// at points all over the mesh, each seen as closely as a covered view can see it, the whole plan
/// together. The promise: any covered view (cli.md) of at least kFewestPixels pixels on the mesh
/// differs by no more than the tolerance. Fails on a tolerance that is not above 0, on no views,
/// or when cancelled.
Result<FitPlan> planFit(const Surface& surface,
                        const TexelStore& texels,
                        const FitSettings& settings,
                        Threads threads,
                        Progress& progress);

/// Puts the fitted faces into the store that the plan was made from. Returns the patch that brings
/// back what was there.
TexelPatch applyFit(const FitPlan& plan, TexelStore& texels);

} // namespace trixel
