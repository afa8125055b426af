// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/filter/level_blend.h"

#include <glm/vec2.hpp>

namespace trixel {

/// What tells the probe methods apart.
struct ProbeSettings
{
    double spacing = 1.4; ///< largest distance of two probes, in sigmas of one probe's kernel
    double band = 1;      ///< of `levelBlend`
    double most = 32;     ///< probes, an even number
};

/// Where to probe: at (k + ½) steps, k = 0, 1, …, from the centre either way, while that is below
/// the support.
///
/// A probe blurs alike in all directions; what the footprint is longer than that along its major
/// axis is left to the weights, (1 - (t/support)²)³. Everything in here changes continuously with
/// the footprint, and weights are 0 where the number of probes changes: nothing pops.
struct ProbePlan
{
    LevelBlend levels;
    glm::dvec2 step{0}; ///< in (u,v) of the face
    float support = 1.5F;
    int perSide = 1;
};

ProbePlan
probePlan(const QueryEllipse& ellipse, const FaceShape& shape, const ProbeSettings& settings);

/// Weight of a probe at t steps.
inline float probeWeight(float t, float support)
{
    const float x = t / support;
    const float y = 1 - x * x;
    return y > 0 ? y * y * y : 0;
}

} // namespace trixel
