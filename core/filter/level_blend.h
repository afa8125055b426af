// SPDX-License-Identifier: GPL-3.0-or-later
//
// Which two levels to read so that what they blur is a wanted variance.
#pragma once

#include "core/filter/query_ellipse.h"

namespace trixel {

/// What one look-up blurs, as a variance per axis in units of the edge of the level's texels
/// squared: averaging texels into coarser ones (1/24) and interpolating between them (c).
/// V_L = 4^L (1/24 + c) - 1/24 in base texels, because the base's texels are points to the exact
/// sum.
inline constexpr double kTexelVariance = 1.0 / 24.0;
inline constexpr double kVertexKernel = 1.0 / 3.0;  ///< vertex averages: c = 7/24
inline constexpr double kHexlinKernel = 5.0 / 36.0; ///< hexlin: c = 7/72

/// Variances of the sharpest look-ups, in squared edges of a base texel: vertex averages of the
/// base, and what probes read beyond it, the base's texels by hexlin (`probe_texels_simd-inl.h`).
inline constexpr double kBaseVariance = kVertexKernel - kTexelVariance;
inline constexpr double kDetailVariance = kHexlinKernel - kTexelVariance;
/// What a level finer than the base would blur by the rule for the others.
inline constexpr double kBeyondVariance = kVertexKernel / 4 - kTexelVariance;

/// Fine and coarse neighbours in the stack of levels.
struct LevelBlend
{
    int fine = 0;           ///< level number; the coarse one is one below
    float coarseWeight = 0; ///< in [0, 1]; 0 where only the fine level is read
    double variance = 0;    ///< that the blend has, plane units squared
};

/// Weights are linear in the variance, so the blend has exactly what was asked for, within what
/// the levels can give. The level is continuous over the mesh because `log2Edge` is; faces clamp it
/// to their own base.
/// \param wanted  variance, plane units squared
/// \param kernel  of the look-up: `kVertexKernel` or `kHexlinKernel`
/// \param band    width of the range of weights in which both levels are read, in (0, 1]: at 1 the
///                variance is met everywhere; below it one level serves most queries
LevelBlend levelBlend(const QueryEllipse& ellipse, double wanted, double kernel, double band);

} // namespace trixel
