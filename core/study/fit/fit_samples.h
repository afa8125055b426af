// SPDX-License-Identifier: GPL-3.0-or-later
//
// The worst that covered views can see of a mesh: points of every face, each with the smallest
// footprint that a covered view can have there.
#pragma once

#include "core/base/face_map.h"
#include "core/filter/filter_queries.h"
#include "core/filter/filter_scene.h"
#include "core/study/fit/face_views.h"

#include <cstdint>
#include <vector>

namespace trixel {

struct FitSamples
{
    /// Round footprints, one finest spacing wide; those of face f from begin[f] to begin[f + 1].
    QueryArrays queries;
    std::vector<std::uint32_t> begin;
    /// Pixels that what is seen of a face fills from straight above at the finest spacing; 0 where
    /// it is not judged.
    FaceMap<double> pixels;
    /// Finest spacing met on the face, world units per pixel; infinite where it is not judged.
    FaceMap<double> spacing;

    /// Whether the fit keeps what is seen of a face.
    bool isJudged(FaceId face) const { return pixels[face] > 0; }
};

/// Where a face is judged: about one point a pixel, up to 256 a face, spread evenly and at random
/// within their cells, but always the same.
/// \param levels  of the faces; no more points than texels
FitSamples fitSamples(const Surface& surface,
                      const FilterSurface& shapes,
                      const FaceMap<Level>& levels,
                      const FaceViews& views,
                      Threads threads);

/// W1 and W2, in (u,v), of a round footprint.
/// \param spacing  world units from pixel to pixel
std::array<glm::vec2, 2> roundFootprint(const FaceShape& shape, double spacing);

/// Mean square difference of each face's samples, over its channels; infinite where a value that
/// was finite is not any more. Samples that were not finite do not count.
/// \param was, is  results of the samples' queries, channel after channel
FaceMap<double> meanSquares(const FitSamples& samples,
                            std::span<const float> was,
                            std::span<const float> is,
                            int channels);

} // namespace trixel
