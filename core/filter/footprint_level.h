// SPDX-License-Identifier: GPL-3.0-or-later
//
// Which mip level is right for a footprint.
#pragma once

#include "core/filter/query_ellipse.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace trixel {

/// Level, any real number, at which a texel's edge is as long as `length` (> 0, plane units) at the
/// query's centre: a field that is continuous over the mesh (`QueryEllipse::log2Edge`).
inline double levelOfEdge(const QueryEllipse& ellipse, double length)
{
    return ellipse.log2Edge - std::log2(length);
}

/// Edge of the level's texels, in standard deviations, at which bilinear interpolation in rows
/// averages like a Gaussian: a texel's own variance s²/24 along any axis and the interpolation's,
/// s²/24 along x and s²/8 along y, make s²/8 in the mean.
inline constexpr double kEdgePerSigma = 2 * std::numbers::sqrt2;

/// The level for filters that know no direction: by the geometric mean of the ellipse's axes.
inline double roundLevel(const QueryEllipse& ellipse)
{
    return levelOfEdge(ellipse, kEdgePerSigma * std::sqrt(ellipse.majorSigma * ellipse.minorSigma));
}

/// The nearest level that the face has.
inline Level nearestLevel(const FilterScene& scene, FaceId face, double level)
{
    const double base = scene.level(face).log2();
    return Level(static_cast<int>(level > 0 ? std::min(std::floor(level + 0.5), base) : 0));
}

/// The finer of the two levels between which a level lies, as results report it.
inline float finerLevel(const FilterScene& scene, FaceId face, double level)
{
    const double base = scene.level(face).log2();
    return static_cast<float>(level > 0 ? std::min(std::ceil(level), base) : 0);
}

} // namespace trixel
