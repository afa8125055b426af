// SPDX-License-Identifier: GPL-3.0-or-later
//
// The formulas as textbooks have them, for the stability study and its tests alone: nothing else
// may call them. What each gets wrong is said with the robust form, which has the same name without
// "naive".
#pragma once

#include "core/filter/filter_surface.h"
#include "core/footprint/covariance.h"
#include "core/footprint/footprint.h"
#include "core/footprint/projected_face.h"
#include "core/lattice/texel.h"
#include "core/mapping/quad.h"
#include "core/mapping/sphere.h"

#include <optional>
#include <span>

namespace trixel::naive {

/// det = xx yy - xy².
Covariance covarianceOf(glm::dvec2 half1, glm::dvec2 half2, double floor);

/// λ_minor = (tr - √(tr² - 4 det)) / 2; the direction is left out.
CovarianceAxes minorBySubtraction(const Covariance& covariance);

/// Direction (xy, λ_major - xx), whatever it is.
CovarianceAxes directionByOneForm(const Covariance& covariance);

/// Axes of the covariance of W1, W2 in single precision, neither limited nor with a floor.
CovarianceAxes singlePrecisionAxes(glm::vec2 w1, glm::vec2 w2);

/// The quotient rule and the inverse Jacobian, without asking where w is.
std::optional<Footprint> footprintOf(const ProjectedFace& face, glm::dvec2 uv);

/// Difference of image coordinates between neighbouring pixels.
Footprint
sphereDifferences(const glm::dvec3& direction, const glm::dvec3& perA, const glm::dvec3& perB);

/// s = atan(z/x)/(π/2), t = atan(y/x)/(π/2), front and rear told apart by the sign of x.
glm::dvec2 sphereUv(const glm::dvec3& direction);

/// The derivatives of longitude and latitude as they stand, divided by x² + z².
Footprint
sphereFootprint(const glm::dvec3& direction, const glm::dvec3& perA, const glm::dvec3& perB);

/// v = (-b + √disc) / 2a, u from the x components.
std::optional<glm::dvec2> inverseBilinear(const Quad& quad, glm::dvec2 point);

/// Texel of a face that lies at `kAtlasOrigin` of a large atlas, in single precision throughout.
TexelCoord texelInAtlas(Level level, glm::dvec2 uv);
inline constexpr float kAtlasOrigin = 12288.0F;

/// Floors of u R and v R as they are, the half by their fractions, nothing brought inside.
TexelCoord unclampedTexelAt(Level level, glm::dvec2 uv);

/// Shape of a face without asking whether it has an area.
FaceShape faceShapeOf(const std::array<glm::vec3, 3>& corners);

/// Weights as products of factors along the whole row, in single precision.
void gaussianWeights(glm::dvec2 start, glm::dvec2 step, double offset, std::span<double> weights);

/// Average of a row of equal values about the middle of two texels: no floor under the variance,
/// divided by whatever the weights add up to. \param sigma  in texels
float rowAverage(float value, float sigma);

/// The same, the sum of weights taken from calculus: σ √2π.
float rowAverageUnnormalised(float value, float sigma);

/// Average of a row with one NaN among its texels, every weight counted however small.
/// \param distance  of the NaN from the centre, in texels
float rowAverageWithNaN(int distance, float sigma);

/// Noise computed from coordinates, fract(43758.5453 sin(12.9898 x + 78.233 y)), as builds with and
/// without fused multiply-add do it.
float proceduralNoise(float x, float y, bool fused);

} // namespace trixel::naive
