// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/texture/face_texels.h"
#include "core/texture/texel_format.h"

namespace trixel {

/// Which four texels a coarser one is the mean of.
enum class ReductionRule : std::uint8_t {
    Triangles, ///< those it covers (`finerPixels`): the right one
    Box        ///< what images do (`boxPixels`): only to be compared with
};

/// The face one level coarser: the mean of four texels, integers rounded to nearest with ties to
/// even, half summed in float and rounded to nearest even.
/// A constant face stays constant. \param face  level 1 or more (checked)
FaceTexels reduced(const TexelFormat& format,
                   const FaceTexels& face,
                   ReductionRule rule = ReductionRule::Triangles);

/// The same on bare texels.
/// \param fine    level of `source`, 1 or more (checked)
/// \param source  4^n texels in packed order (checked)
/// \param target  4^(n-1) texels (checked), not overlapping the source
void reduceTexels(const TexelFormat& format,
                  Level fine,
                  std::span<const std::byte> source,
                  std::span<std::byte> target,
                  ReductionRule rule = ReductionRule::Triangles);

/// The face `steps` levels coarser, not below level 0, by the rule for triangles.
FaceTexels reduced(const TexelFormat& format, const FaceTexels& face, int steps);

} // namespace trixel
