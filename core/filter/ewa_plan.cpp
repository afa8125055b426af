// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/filter/ewa_plan.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace trixel {
namespace {

/// Part of the taps that is planned with: faces differ from the lengths about them.
constexpr double kPlannedShare = 0.8;

/// Up to which level two may be blended, continuous in its arguments: the finer of them must not be
/// above `finest`, unless it is the base, which is then read alone.
double blendedLimit(double finest, double base)
{
    if (finest < base) {
        return finest - 1;
    }
    return finest < base + 0.5 ? base - 1 + 2 * (finest - base) : finest - 0.5;
}

} // namespace

void EwaPlan::reduce()
{
    if (fine > 0) {
        coarse = std::max(coarse - 1, 0);
        fine = coarse;
        blend = 1;
    } else {
        majorSigma /= 2;
        minorSigma /= 2;
    }
}

EwaPlan
planEwa(const EwaSettings& settings, const GaussianWindow& window, const QueryEllipse& ellipse)
{
    EwaPlan plan;
    plan.majorAxis = ellipse.majorAxis;
    plan.majorSigma = ellipse.majorSigma;
    if (settings.atBase) {
        plan.minorSigma = ellipse.minorSigma;
        plan.coarse = Level::kMax;
        plan.fine = Level::kMax;
        return plan;
    }
    plan.minorSigma = std::max(ellipse.minorSigma, ellipse.majorSigma / settings.mostAnisotropy);

    // Texels under the window at level 0, of edge 2^log2Edge; four times as many a level finer.
    const double squaredCut = window.cut() * window.cut() / window.variance();
    const double texelArea = std::sqrt(3.0) / 4 * std::exp2(2 * ellipse.log2Edge);
    const double taps =
        std::numbers::pi * squaredCut * plan.majorSigma * plan.minorSigma / texelArea;
    const double levels = settings.blended ? 1.25 : 1.0; // the coarser of two adds a quarter
    double finest = std::log2(kPlannedShare * settings.mostTaps / (levels * taps)) / 2;
    if (finest < 0) {
        plan.majorSigma *= std::exp2(finest);
        plan.minorSigma *= std::exp2(finest);
        finest = 0;
    }
    const double wanted = ellipse.log2Edge - std::log2(plan.minorSigma / settings.sigma);
    if (!settings.blended) {
        plan.fine = static_cast<int>(
            std::clamp(std::min(std::ceil(wanted), std::floor(finest)), 0.0, double{Level::kMax}));
        plan.coarse = plan.fine;
        return plan;
    }
    const double limit = blendedLimit(finest, ellipse.log2Edge - ellipse.log2Texel);
    const double level = std::clamp(std::min(wanted, limit), 0.0, double{Level::kMax});
    plan.coarse = static_cast<int>(level);
    plan.fine = std::min(plan.coarse + 1, Level::kMax);
    plan.blend = level - plan.coarse;
    return plan;
}

} // namespace trixel
