// SPDX-License-Identifier: GPL-3.0-or-later
//
// Two-by-two forms that keep their digits where the textbook's subtract almost equal numbers.
#pragma once

#include <glm/vec2.hpp>

namespace trixel {

/// a d - b c with at most 1.5 ulp of error (Kahan; needs a fused multiply-add).
double differenceOfProducts(double a, double d, double b, double c);

/// Singular values and directions of the matrix with columns c1, c2: [c1 c2] v = size u.
/// Directions are always of unit length, also for a circle or a zero matrix.
struct Svd2
{
    double major = 0; ///< larger singular value
    double minor = 0; ///< smaller one, as |det| / major: never negative, never above `major`
    glm::dvec2 majorFrom{1, 0}; ///< v of the larger
    glm::dvec2 majorTo{1, 0};   ///< u of the larger
    glm::dvec2 minorFrom{0, 1}; ///< v of the smaller
    glm::dvec2 minorTo{0, 1};   ///< u of the smaller
};

/// \param c1, c2  finite; any size (they are scaled first)
Svd2 svd2(glm::dvec2 c1, glm::dvec2 c2);

/// The same when the caller knows the determinant better than the columns tell it.
/// \param det  of [c1 c2]
Svd2 svd2(glm::dvec2 c1, glm::dvec2 c2, double det);

} // namespace trixel
