// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/footprint/gaussian_weights.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <glm/geometric.hpp>

namespace trixel {

namespace {

constexpr std::size_t kRestart = 64;

/// The logarithm of weight k.
double exponent(glm::dvec2 start, glm::dvec2 step, double offset, std::size_t k)
{
    const glm::dvec2 p = start + static_cast<double>(k) * step;
    return (offset - glm::dot(p, p)) / 2;
}

} // namespace

void gaussianWeights(glm::dvec2 start, glm::dvec2 step, double offset, std::span<double> weights)
{
    // A parabola is largest inside and least at an end: both ends in range, all but the peak is.
    constexpr double kLeast = -600;
    constexpr double kMost = 600;
    const double squared = glm::dot(step, step);
    const double change = std::exp(-squared);
    for (std::size_t begin = 0; begin < weights.size(); begin += kRestart) {
        const std::size_t end = std::min(begin + kRestart, weights.size());
        const glm::dvec2 p = start + static_cast<double>(begin) * step;
        const double first = (offset - glm::dot(p, p)) / 2;
        const double slope = -(glm::dot(p, step) + squared / 2);
        const bool inRange = first > kLeast && first < kMost && std::abs(slope) < kMost &&
                             exponent(start, step, offset, end - 1) > kLeast;
        if (!inRange) {
            for (std::size_t k = begin; k < end; ++k) {
                weights[k] = std::exp(exponent(start, step, offset, k));
            }
            continue;
        }
        double weight = std::exp(first);
        double ratio = std::exp(slope);
        for (std::size_t k = begin; k < end; ++k) {
            weights[k] = weight;
            weight *= ratio;
            ratio *= change;
        }
    }
}

} // namespace trixel
