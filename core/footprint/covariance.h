// SPDX-License-Identifier: GPL-3.0-or-later
//
// The Gaussian of a footprint, in forms that hold for vectors that are parallel, alike or nothing.
#pragma once

#include <glm/vec2.hpp>

namespace trixel {

/// Covariance of two conjugate half axes plus a floor, with a determinant that does not come from
/// subtracting almost equal numbers.
struct Covariance
{
    double xx = 0, xy = 0, yy = 0;
    double determinant = 0; ///< never negative; positive where the floor is
};

/// half1 half1ᵀ + half2 half2ᵀ + floor on the diagonal. The determinant is det + b tr + b² with
/// b the floor and det = (half1 × half2)², a difference of products after Kahan.
/// \param floor  >= 0, a variance
Covariance covarianceOf(glm::dvec2 half1, glm::dvec2 half2, double floor);

/// Square roots of the eigenvalues and the direction of the larger.
struct CovarianceAxes
{
    double majorSigma = 0;
    double minorSigma = 0;      ///< <= majorSigma
    glm::dvec2 majorAxis{1, 0}; ///< of unit length, (1,0) for a circle
};

/// λ_minor = determinant / λ_major; the direction is the longer of the two columns that are
/// multiples of it.
CovarianceAxes axesOf(const Covariance& covariance);

} // namespace trixel
