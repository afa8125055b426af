// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a query means, for every filter alike: the Gaussian to average with.
#pragma once

#include "core/filter/filter_queries.h"
#include "core/filter/filter_scene.h"

#include <glm/vec2.hpp>

namespace trixel {

/// Longest W that is taken as it is, in edges of the face; longer ones are scaled down to it, and a
/// W that is not finite counts as this wide in all directions.
inline constexpr double kWidestFootprint = 1024.0;

/// Covariance Σ = ¼ (W1 W1ᵀ + W2 W2ᵀ) in the face's plane plus ¼ s² on the diagonal, s the edge of
/// a texel there (`FilterScene::log2TexelSize`). On equilateral faces of one level that is the
/// reference library's. Always positive definite: the determinant is taken as det + b tr + b² with
/// b = ¼ s² and det = (W1 × W2)²/16, which does not subtract almost equal numbers.
struct QueryEllipse
{
    /// Whether u and v were finite. If not, the answer is the average of the face.
    bool hasCentre = true;
    glm::dvec2 uv{0};              ///< centre, brought into the face
    glm::dvec2 centre{0};          ///< the same in the face's plane
    double xx = 0, xy = 0, yy = 0; ///< Σ, plane units squared
    double determinant = 0;        ///< of Σ
    double majorSigma = 0;         ///< square roots of the eigenvalues, plane units
    double minorSigma = 0;
    glm::dvec2 majorAxis{1, 0}; ///< of unit length, in the plane
    double log2Texel = 0;       ///< log2 s
    double log2Edge = 0;        ///< `FilterSurface::log2Length` there: level n has texels of
                                ///< edge 2^(log2Edge - n), continuous over the mesh

    glm::dvec2 minorAxis() const { return {-majorAxis.y, majorAxis.x}; }
};

QueryEllipse
queryEllipse(const FilterScene& scene, FaceId face, glm::dvec2 uv, glm::dvec2 w1, glm::dvec2 w2);
QueryEllipse
queryEllipse(const FilterScene& scene, const FilterQueries& queries, std::size_t index);

/// The point of the face nearest in barycentric terms: negative coordinates become 0, a sum above 1
/// is scaled to 1. NaN stays NaN.
glm::dvec2 broughtInside(glm::dvec2 uv);

} // namespace trixel
