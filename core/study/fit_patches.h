// SPDX-License-Identifier: GPL-3.0-or-later
//
// A picture's error is a mean over its pixels. Patches are pieces of surface as large as the
// smallest picture that a fit promises anything for: while the mean over each patch is within the
// tolerance, so is the mean over whatever a picture shows of them.
#pragma once

#include "core/base/face_map.h"
#include "core/base/level.h"
#include "core/mesh/adjacency.h"
#include "core/study/fit_samples.h"

#include <cstdint>
#include <span>
#include <vector>

namespace trixel {

/// Pixels that a patch fills at the finest spacing: about so many, or one face where that is more.
inline constexpr double kPatchPixels = 512;

/// Faces that hang together.
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

/// Grown across edges from the lowest face that is left, breadth first. Faces that no view frames
/// are in no patch.
FitPatches fitPatches(const Adjacency& adjacency, const FitSamples& samples);

/// What the faces of a patch would cost and err, coarser by 0, 1, 2 … levels.
struct FitOptions
{
    /// errors[k][face]: mean square error with every face k levels coarser; errors[0] is 0.
    std::vector<FaceMap<double>> errors;
};

/// Mean of `squares` over a patch, by pixels.
double patchMeanSquare(std::span<const FaceId> patch,
                       const FitSamples& samples,
                       const FaceMap<double>& squares);

/// For each face of a patch how many levels coarser it may become, so that the patch's mean square
/// stays within `most` and no face's exceeds kWorstFace² times that: one step at a time, always the
/// one that saves the most texels for what it adds.
void chooseSteps(std::span<const FaceId> patch,
                 const FitSamples& samples,
                 const FitOptions& options,
                 const FaceMap<Level>& levels,
                 double most,
                 FaceMap<int>& steps);

/// Most RMS of one face, in tolerances.
inline constexpr double kWorstFace = 3;

} // namespace trixel
