// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <glm/vec2.hpp>
#include <span>

namespace trixel {

/// Weights of a Gaussian along a row of points: weights[k] = exp((offset - |start + k step|²) / 2),
/// start and step in standard deviations.
///
/// From one point to the next the weight changes by a factor that itself changes by a constant
/// factor. Such a product drifts, so it starts anew from `exp` every 64 points; and it cannot leave
/// 0, so that where the weights or their ratio leave the range of numbers each is an `exp` of its
/// own. Relative error below 1e-11, of weights above 1e-280.
/// \param step  finite, not 0
void gaussianWeights(glm::dvec2 start, glm::dvec2 step, double offset, std::span<double> weights);

} // namespace trixel
