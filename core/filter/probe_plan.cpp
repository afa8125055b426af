// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/filter/probe_plan.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace trixel {
namespace {

/// 1 / sigma of the weights exp(-c x²) - exp(-c) on [-1, 1].
double supportInSigmas(double c)
{
    const double end = std::exp(-c);
    const double bell = std::sqrt(std::numbers::pi / c) / 2 * std::erf(std::sqrt(c));
    const double sum = bell - end;
    const double squares = (bell - end) / (2 * c) - end / 3;
    return std::sqrt(sum / squares);
}

} // namespace

ProbeSettings probeSettings(int most, double band)
{
    const double doublings = std::log2(most);
    ProbeSettings settings;
    settings.band = band;
    settings.most = most;
    settings.spacing = 3.0 - 0.3 * doublings;
    settings.falloff = std::max(0.8 * (doublings - 1), 1.0);
    settings.across = most >= kLeastOfTwoLines ? kAcrossShare : 0;
    settings.support = supportInSigmas(settings.falloff);
    return settings;
}

ProbeCap probeCap(const ProbeSettings& settings)
{
    // The support is (most + 1)/2 steps at most, each spacing * anisotropy^kWidening * sigma; there
    // the anisotropy is support / (sigmas of the weights) / sigma to a hair.
    const double evenly = settings.spacing * (settings.most + 1) / (2 * settings.support);
    const double longest = std::pow(std::max(evenly, 1.0), 1 / (1 - kWidening));
    return {1 / (1 + longest * longest), 2.0 / (settings.most + 1)};
}

} // namespace trixel
