// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/footprint/gaussian_weights.h"

#include "core/study/stability_naive.h"

namespace trixel {

void gaussianWeights(glm::dvec2 start, glm::dvec2 step, double offset, std::span<double> weights)
{
    naive::gaussianWeights(start, step, offset, weights);
}

} // namespace trixel
