// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/filter/probe_plan.h"

#include <algorithm>
#include <cmath>

namespace trixel {
namespace {

/// Support of (1 - (t/support)²)³ in sigmas: its variance is support²/9.
constexpr double kSupport = 3.0;
/// A footprint that is no longer than this for its width, in parts of its variance, counts as
/// round: below it the rounding of W to floats decides which way its major axis points.
constexpr double kRound = 1e-4;
/// Longest line to a side, in edges of faces about the centre: keeps hostile footprints affordable.
constexpr double kMostEdges = 128.0;

} // namespace

ProbePlan
probePlan(const QueryEllipse& ellipse, const FaceShape& shape, const ProbeSettings& settings)
{
    const double edge = std::exp2(ellipse.log2Edge);
    const double majorSigma = std::min(ellipse.majorSigma, kMostEdges / kSupport * edge);
    const double major = majorSigma * majorSigma;
    // With `most` probes the support is (most + 1)/2 steps of spacing * sigma; where that is too
    // short for the major axis, probes blur more instead.
    const double ratio = 2 * kSupport / (settings.spacing * (settings.most + 1));
    const double least = ratio * ratio / (1 + ratio * ratio) * major;
    const double minor = std::max(ellipse.minorSigma * ellipse.minorSigma, least);

    ProbePlan plan;
    plan.levels = levelBlend(ellipse, minor, kVertexKernel, settings.band);
    // Along the major axis the probes make up for what their kernel lacks, too. A circle has no
    // such axis: there the lack has to stay, or the answer would depend on which direction is
    // called the major one.
    const double lack = (minor - plan.levels.variance) * (1 - minor / std::max(major, minor));
    const double rest = std::sqrt(std::max((1 - kRound) * major - minor + lack, 0.0));
    const double most = settings.spacing * std::sqrt(plan.levels.variance);
    // Two probes one sigma from the centre have the variance to a hair; closer than that the
    // spacing shrinks instead of the number.
    const double step =
        std::max(std::min(most, 2 * rest), kSupport * rest * 2 / (settings.most + 1));
    plan.step = shape.toUv(ellipse.majorAxis * step);
    plan.support = step > 0 ? static_cast<float>(kSupport * rest / step) : 1.5F;
    plan.perSide = std::max(1, static_cast<int>(std::ceil(plan.support - 0.5F)));
    return plan;
}

} // namespace trixel
