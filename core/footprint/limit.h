// SPDX-License-Identifier: GPL-3.0-or-later
//
// Bringing footprints of any size to one that can be squared.
#pragma once

#include "core/footprint/footprint.h"
#include "core/footprint/svd2.h"

namespace trixel {

/// The vector scaled down to `longest` where it is longer. Scaled by its larger component first, so
/// that no square overflows or vanishes. A vector that is not finite comes back as it is.
glm::dvec2 limitedVector(glm::dvec2 w, double longest);

/// The footprint of equal width in all directions: what stands in for one that is not finite.
Footprint roundFootprint(double width);

/// Both axes limited to `maxLength` (in uv), their directions kept; the widest footprint where a
/// number is not finite. Turning the pair (W1, W2) turns the result.
Footprint limitedTo(const Footprint& footprint, double maxLength);

/// The matrix that an SVD is of, columns W1 and W2, its two lengths given by the caller.
/// \param longer   in the place of svd.major
/// \param shorter  in the place of svd.minor
Footprint withLengths(const Svd2& svd, double longer, double shorter);

/// The inverse of the matrix that an SVD is of, columns W1 and W2, its two lengths given by the
/// caller instead of taken as reciprocals.
/// \param shorter  stands in for 1 / svd.major
/// \param longer   stands in for 1 / svd.minor
Footprint inverseWithLengths(const Svd2& svd, double shorter, double longer);

/// A limit that callers may give as any number: in [0, 2^20], NaN as the largest.
double usableLimit(double maxLength);

} // namespace trixel
