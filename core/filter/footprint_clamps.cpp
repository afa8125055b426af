// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/filter/footprint_clamps.h"

#include "core/footprint/svd2.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace trixel {
namespace {

/// Differences that are told, as a factor.
constexpr double kTold = 1.1;

bool isFinite(glm::dvec2 v)
{
    return std::isfinite(v.x) && std::isfinite(v.y);
}

} // namespace

std::vector<FootprintClamp> clampsOf(const PlacedFootprint& footprint,
                                     const FootprintNet& net,
                                     bool fromScreen,
                                     const std::optional<WeightEllipse>& weights)
{
    using Kind = FootprintClamp::Kind;
    std::vector<FootprintClamp> clamps;
    const auto [w1, w2] = footprint.footprint;
    const bool finite = isFinite(w1) && isFinite(w2);
    if (!finite) {
        clamps.push_back({Kind::NotFinite, 0, kWidestFootprint});
    } else {
        const double longest = std::max(glm::length(w1), glm::length(w2));
        if (longest > kWidestFootprint) {
            clamps.push_back({Kind::Shortened, longest, kWidestFootprint});
        }
        if (fromScreen && svd2(w1, w2).major >= kGrazingLimit * (1 - 1e-6)) {
            clamps.push_back({Kind::Grazing, INFINITY, kGrazingLimit});
        }
    }
    if (isFinite(footprint.uv) && broughtInside(footprint.uv) != footprint.uv) {
        clamps.push_back(
            {Kind::CentreMoved, glm::distance(footprint.uv, broughtInside(footprint.uv)), 0});
    }
    const double texel = std::exp2(net.ellipse.log2Texel);
    const double minor = glm::length(net.minor);
    if (net.ellipse.minorSigma > kTold * minor) {
        clamps.push_back({Kind::Widened, minor / texel, net.ellipse.minorSigma / texel});
    }
    // Level of texels as wide as the ellipse, as `EllipseReport` has it, but without bounds.
    const double level = net.ellipse.log2Edge - std::log2(2 * minor);
    const double base = net.faces.front().level.log2();
    if (level > base) {
        clamps.push_back({Kind::FinestLevel, level, base});
    } else if (level < 0) {
        clamps.push_back({Kind::CoarsestLevel, level, 0});
    }
    if (weights) {
        if (weights->minorSigma > kTold * net.ellipse.minorSigma) {
            clamps.push_back(
                {Kind::MethodWidened, net.ellipse.minorSigma / texel, weights->minorSigma / texel});
        }
        if (weights->majorSigma * kTold < net.ellipse.majorSigma) {
            clamps.push_back({Kind::MethodShortened,
                              net.ellipse.majorSigma / texel,
                              weights->majorSigma / texel});
        }
    }
    return clamps;
}

} // namespace trixel
