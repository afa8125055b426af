// SPDX-License-Identifier: GPL-3.0-or-later
//
// Which mip level is right for a footprint.
#pragma once

#include "core/filter/query_ellipse.h"

#include <algorithm>
#include <cmath>

namespace trixel {

/// Level, any real number, at which a texel's edge is as long as `length` (> 0, plane units) at the
/// query's centre: a field that is continuous over the mesh (`QueryEllipse::log2Edge`).
inline double levelOfEdge(const QueryEllipse& ellipse, double length)
{
    return ellipse.log2Edge - std::log2(length);
}

/// Width that filters which know no direction take an ellipse to have.
inline double roundWidth(const QueryEllipse& ellipse)
{
    return 2 * std::sqrt(ellipse.majorSigma * ellipse.minorSigma);
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
