// SPDX-License-Identifier: GPL-3.0-or-later
//
// The inverse bilinear quad: near a parallelogram, without area, crossed over.
#include "core/mapping/quad.h"
#include "core/study/stability/naive_forms.h"
#include "core/study/stability/sweeps.h"
#include "core/study/stability/truth.h"

#include <algorithm>

namespace trixel::sweeps {

namespace {

LongVec2 trueBilinear(const Quad& q, const LongVec2& uv)
{
    const LongVec2 p00(q.p00);
    const LongVec2 b = LongVec2(q.p10) - p00;
    const LongVec2 c = LongVec2(q.p01) - p00;
    return p00 + uv.x * b + uv.y * c + uv.x * uv.y * (LongVec2(q.p11) - LongVec2(q.p01) - b);
}

/// Distance between the point and what the found (u,v) leads to; the quad's size is about 1.
double reprojection(const Quad& quad, const std::optional<glm::dvec2>& found, glm::dvec2 point)
{
    if (!found) {
        return kNoAnswer;
    }
    const LongVec2 off = trueBilinear(quad, LongVec2(*found)) - LongVec2(point);
    const auto error = static_cast<double>(std::hypot(off.x, off.y));
    return std::isfinite(error) ? error : kNoAnswer;
}

double distanceFromSquare(const std::optional<glm::dvec2>& uv)
{
    return uv ? std::max({-uv->x, uv->x - 1, -uv->y, uv->y - 1, 0.0}) : kNoAnswer;
}

} // namespace

StabilitySweep parallelogram()
{
    StabilitySweep sweep{
        .name = "parallelogram",
        .title = "Quads near a parallelogram",
        .hazard = "The textbook's root of the quadratic is a difference over what tends to 0.",
        .property = "The (u,v) found leads back to the point.",
        .axisTitle = "distance of P11 from the parallelogram",
        .errorTitle = "reprojection over size",
        .bound = 5e-7};
    sweep.values = geometric(0.1, 1e-17, 0.1, {0});
    addCurves(sweep, "(-b - \u221Adisc) / 2a", "c/q or q/a, Newton", [](double off) {
        ErrorPair errors;
        SweepRandom random;
        for (int k = 0; k < 64; ++k) {
            const glm::dvec2 p00(random.in(-1, 1), random.in(-1, 1));
            const glm::dvec2 b(random.in(0.6, 1), random.in(-0.2, 0.2));
            const glm::dvec2 c(random.in(-0.2, 0.2), random.in(0.6, 1));
            const Quad quad{p00, p00 + b, p00 + b + c + off * glm::dvec2(0.8, -0.6), p00 + c};
            const LongVec2 uv(random.in(0, 1), random.in(0, 1));
            const glm::dvec2 point(trueBilinear(quad, uv));
            errors.add(reprojection(quad, naive::inverseBilinear(quad, point), point),
                       reprojection(quad, inverseBilinear(quad, point), point));
        }
        return errors;
    });
    return sweep;
}

StabilitySweep flatQuad()
{
    StabilitySweep sweep{
        .name = "flat-quad",
        .title = "Quads without area",
        .hazard = "Every coefficient of the quadratic tends to 0 together.",
        .property = "The (u,v) found leads back to the point, or the quad is rejected for its "
                    "area (below 1e-12).",
        .axisTitle = "height over length",
        .errorTitle = "reprojection over size",
        .bound = 5e-7};
    sweep.values = geometric(1, 1e-18, 0.1, {0});
    addCurves(sweep, "(-b - \u221Adisc) / 2a", "c/q or q/a, by area", [](double height) {
        ErrorPair errors;
        SweepRandom random;
        for (int k = 0; k < 64; ++k) {
            const double slope = random.in(-0.5, 0.5);
            const auto at = [&](double x, double y) {
                return glm::dvec2(x, slope * x + height * y);
            };
            const Quad quad{at(0, 0), at(0.9, 0.1), at(1, 1.1), at(0.1, 0.9)};
            const LongVec2 uv(random.in(0, 1), random.in(0, 1));
            const glm::dvec2 point(trueBilinear(quad, uv));
            const auto robust = inverseBilinear(quad, point);
            const bool mayReject = height < 1e-11;
            errors.add(reprojection(quad, naive::inverseBilinear(quad, point), point),
                       !robust && mayReject ? 0 : reprojection(quad, robust, point));
        }
        return errors;
    });
    return sweep;
}

StabilitySweep bowTie()
{
    StabilitySweep sweep{
        .name = "bow-tie",
        .title = "From a square to a bow-tie",
        .hazard = "Where the quad folds over, one fixed sign of the root leads outside of it.",
        .property = "A point of the quad comes back inside the unit square and leads to itself.",
        .axisTitle = "P10 and P11 exchanged by",
        .axis = SweepAxis::Linear,
        .errorTitle = "reprojection, or distance outside",
        .bound = 5e-7};
    for (int k = 0; k <= 20; ++k) {
        sweep.values.push_back(sweepValue(k / 20.0));
    }
    addCurves(sweep, "(-b - \u221Adisc) / 2a", "fixed rule for two roots", [](double amount) {
        ErrorPair errors;
        SweepRandom random;
        const Quad quad{{0, 0}, {1, amount}, {1.1, 1 - amount}, {0, 1}};
        for (int k = 0; k < 256; ++k) {
            const LongVec2 uv(random.in(0, 1), random.in(0, 1));
            const glm::dvec2 point(trueBilinear(quad, uv));
            const auto error = [&](const std::optional<glm::dvec2>& found) {
                return worse(reprojection(quad, found, point), distanceFromSquare(found));
            };
            errors.add(error(naive::inverseBilinear(quad, point)),
                       error(inverseBilinear(quad, point)));
        }
        return errors;
    });
    return sweep;
}

} // namespace trixel::sweeps
