// SPDX-License-Identifier: GPL-3.0-or-later
//
// A picture's error is a mean over its pixels. Patches are pieces of surface as large as the
// smallest picture that a fit promises anything for: while the mean over each patch is within the
// tolerance, so is the mean over whatever a picture shows of them.
#pragma once

#include "core/base/face_map.h"
#include "core/base/level.h"
#include "core/mesh/adjacency.h"
#include "core/study/fit/fit_samples.h"

#include <cstdint>
#include <span>
#include <vector>

namespace trixel {

/// Pixels that a patch fills at the finest spacing: about so many, or one face where that is more.
/// Half of what a picture must show, for pictures have other shapes than patches.
inline constexpr double kPatchPixels = 2048;

/// Faces that hang together, patch after patch; patches overlap.
struct FitPatches
{
    std::vector<FaceId> faces;        ///< those of patch p from begin[p] to begin[p + 1]
    std::vector<std::uint32_t> begin; ///< one more than there are patches

    std::size_t size() const { return begin.size() - 1; }
    std::span<const FaceId> patch(std::size_t p) const
    {
        return std::span(faces).subspan(begin[p], begin[p + 1] - begin[p]);
    }
};

/// Each grown across edges, breadth first, from the lowest face that is not yet within the inner
/// quarter of another. Faces that are not judged are in no patch.
FitPatches fitPatches(const Adjacency& adjacency, const FitSamples& samples);

/// Mean of `squares` over a patch, by pixels.
double patchMeanSquare(std::span<const FaceId> patch,
                       const FitSamples& samples,
                       const FaceMap<double>& squares);

/// What each face is expected to err, coarser by 0, 1, 2 … levels: errors[k][face], mean square.
struct FitOptions
{
    std::vector<FaceMap<double>> errors;
};

/// Most RMS that one face is expected to have, in tolerances.
inline constexpr double kWorstFace = 3;

/// Gives up more levels than `steps` does, so that the mean square of no patch exceeds `most`, but
/// where it does already, and no face's exceeds kWorstFace² times that: always the step, of one
/// level or more, that saves the most texels for what it adds.
/// \param part  of the room that each patch has left to be used, in (0, 1]
void chooseSteps(const FitPatches& patches,
                 const FitSamples& samples,
                 const FitOptions& options,
                 const FaceMap<Level>& levels,
                 double most,
                 double part,
                 FaceMap<int>& steps);

} // namespace trixel
