// SPDX-License-Identifier: GPL-3.0-or-later
//
// Ellipses of footprints: parallel vectors, long ellipses, circles, vectors of any length.
#include "core/filter/query_ellipse.h"
#include "core/footprint/covariance.h"
#include "core/study/stability/naive_forms.h"
#include "core/study/stability/scenes.h"
#include "core/study/stability/sweeps.h"
#include "core/study/stability/truth.h"

#include <algorithm>
#include <array>
#include <glm/geometric.hpp>
#include <numbers>

namespace trixel::sweeps {

namespace {

struct Pair
{
    glm::dvec2 a;
    glm::dvec2 b;
};

/// Two half axes of unlike lengths at an angle, the first in any direction.
Pair atAngle(double angle, double direction, double length)
{
    return {{std::cos(direction), std::sin(direction)},
            length * glm::dvec2(std::cos(direction + angle), std::sin(direction + angle))};
}

/// Of the numbers as rounded to double.
long double trueCross(const Pair& p)
{
    return cross(LongVec2(p.a), LongVec2(p.b));
}

/// Relative error, infinite for what cannot be a determinant of vectors that are not parallel.
double determinantError(double found, long double expected)
{
    return found > 0 ? relativeError(found, expected) : kNoAnswer;
}

/// The smaller singular value of [a b]: |cross| over the larger.
long double trueMinor(const Pair& p)
{
    const auto square = [](long double x) { return x * x; };
    const long double trace = square(p.a.x) + square(p.a.y) + square(p.b.x) + square(p.b.y);
    const long double area = std::abs(trueCross(p));
    const long double major =
        (std::sqrt(trace + 2 * area) + std::sqrt(std::max(trace - 2 * area, 0.0L))) / 2;
    return area / major;
}

/// How far a direction is from the one of largest variance: the loss of variance along it, and what
/// its length is off 1.
double directionError(const Covariance& c, glm::dvec2 d, double majorSigma)
{
    const double along = c.xx * d.x * d.x + 2 * c.xy * d.x * d.y + c.yy * d.y * d.y;
    const double most = majorSigma * majorSigma;
    const double error = std::max(std::abs(glm::length(d) - 1), (most - along) / most);
    return std::isfinite(error) ? std::max(error, 0.0) : kNoAnswer;
}

} // namespace

StabilitySweep parallelVectors()
{
    StabilitySweep sweep{
        .name = "parallel-vectors",
        .title = "W1 and W2 almost parallel",
        .hazard = "det \u03A3 = xx yy - xy\u00B2 subtracts almost equal numbers and turns "
                  "negative.",
        .property = "det \u03A3 is positive and right.",
        .axisTitle = "angle between them (rad)",
        .errorTitle = "relative error of det \u03A3",
        .bound = 1e-6};
    sweep.values = geometric(1, 1e-10, 1 / std::sqrt(10.0));
    addCurves(sweep, "xx yy - xy\u00B2", "(W1 \u00D7 W2)\u00B2, Kahan", [](double angle) {
        ErrorPair errors;
        SweepRandom random;
        for (int k = 0; k < 64; ++k) {
            const Pair p = atAngle(angle, random.in(0, 2 * std::numbers::pi), random.in(0.1, 10));
            const long double truth = trueCross(p) * trueCross(p);
            errors.add(determinantError(naive::covarianceOf(p.a, p.b, 0).determinant, truth),
                       determinantError(covarianceOf(p.a, p.b, 0).determinant, truth));
        }
        return errors;
    });
    return sweep;
}

StabilitySweep minorAxis()
{
    StabilitySweep sweep{
        .name = "minor-axis",
        .title = "Minor axis of a long ellipse",
        .hazard = "\u03BB_minor = (tr - \u221A(tr\u00B2 - 4 det)) / 2 loses all digits to the "
                  "difference.",
        .property = "The minor half axis is right at any anisotropy.",
        .axisTitle = "anisotropy",
        .errorTitle = "relative error of \u03C3_minor",
        .bound = 1e-6};
    sweep.values = geometric(1, 1e10, std::sqrt(10.0));
    addCurves(sweep, "difference", "det / \u03BB_major", [](double anisotropy) {
        ErrorPair errors;
        SweepRandom random;
        for (int k = 0; k < 64; ++k) {
            // Conjugate half axes of one ellipse, turned against each other.
            const double turn = random.in(0, 2 * std::numbers::pi);
            const double mix = random.in(0, 2 * std::numbers::pi);
            const glm::dvec2 major(std::cos(turn), std::sin(turn));
            const glm::dvec2 minor = glm::dvec2(-major.y, major.x) / anisotropy;
            const Pair p{std::cos(mix) * major + std::sin(mix) * minor,
                         -std::sin(mix) * major + std::cos(mix) * minor};
            const Covariance c = covarianceOf(p.a, p.b, 0);
            const long double truth = trueMinor(p);
            errors.add(relativeError(naive::minorBySubtraction(c).minorSigma, truth),
                       relativeError(axesOf(c).minorSigma, truth));
        }
        return errors;
    });
    return sweep;
}

StabilitySweep nearCircle()
{
    StabilitySweep sweep{.name = "near-circle",
                         .title = "Major direction near a circle",
                         .hazard = "(xy, \u03BB - xx) is 0/0 at a circle and along the axes.",
                         .property = "The direction has unit length and the largest variance.",
                         .axisTitle = "anisotropy - 1",
                         .errorTitle = "variance lost, length off 1",
                         .bound = 1e-9};
    sweep.values = geometric(1, 1e-16, 0.1, {0});
    addCurves(sweep, "one form", "longer of two", [](double excess) {
        ErrorPair errors;
        for (int k = 0; k < 16; ++k) {
            const double turn = std::numbers::pi * k / 16;
            glm::dvec2 along(std::cos(turn), std::sin(turn));
            if (k == 8) {
                along = {0, 1}; // exactly
            }
            const glm::dvec2 across(-along.y, along.x);
            const Covariance c = covarianceOf((1 + excess) * along, across, 0);
            const CovarianceAxes robust = axesOf(c);
            const double sigma = robust.majorSigma;
            errors.add(directionError(c, naive::directionByOneForm(c).majorAxis, sigma),
                       directionError(c, robust.majorAxis, sigma));
        }
        return errors;
    });
    return sweep;
}

StabilitySweep vectorLength()
{
    StabilitySweep sweep{
        .name = "vector-length",
        .title = "W of any length",
        .hazard = "Single precision overflows from |W| ~ 1e10 on and underflows near 0; a W that "
                  "is not a number spoils all.",
        .property = "Both axes are finite, positive and right for W limited to 1024 edges with "
                    "its floor of half a texel.",
        .axisTitle = "|W| (edges)",
        .errorTitle = "relative error of \u03C3",
        .bound = 1e-6};
    sweep.values = geometric(1e-30, 1e30, 1e3);
    sweep.values.insert(sweep.values.begin(), {sweepValue(0), sweepValue(1.4e-45)});
    sweep.values.push_back(sweepValue(3.4e38));
    sweep.values.push_back(sweepValue(std::numeric_limits<double>::infinity()));
    sweep.values.push_back(sweepValue(std::numeric_limits<double>::quiet_NaN()));
    const FilterScene scene = flatScene(Level(4));
    const long double floor = 1.0L / 4 / 256; // ¼ texel² at level 4
    addCurves(sweep, "float, as it comes", "limited, with floor", [&](double length) {
        // W1 along X, W2 across it in the equilateral plane, a quarter as long.
        const auto w1 = glm::vec2(static_cast<float>(length), 0.0F);
        const auto across = static_cast<float>(length / 2 / std::numbers::sqrt3);
        const glm::vec2 w2(-across / 2, across);
        const double planeLength = static_cast<double>(across) * std::numbers::sqrt3 / 2;
        const bool finite = std::isfinite(length);
        // The textbook's answer is judged by W as it is, ours by W as it is limited.
        const CovarianceAxes textbook =
            naive::singlePrecisionAxes(w1, {0.0F, static_cast<float>(planeLength)});
        const double asItIs = std::max(relativeError(textbook.majorSigma, length / 2.0L),
                                       relativeError(textbook.minorSigma, planeLength / 2.0L));
        const QueryEllipse ellipse = queryEllipse(scene, FaceId{0}, {0.3, 0.3}, w1, w2);
        const auto sigma = [&](long double width) {
            const long double half = width / 2;
            return std::sqrt(half * half + floor);
        };
        const double limit = kWidestFootprint;
        const double w2Length = glm::length(glm::dvec2(w2));
        const long double scale = w2Length > limit ? limit / w2Length : 1.0L;
        const long double major = sigma(finite ? std::min(length, limit) : limit);
        const long double minor = sigma(finite ? planeLength * scale : limit);
        return ErrorPair{asItIs,
                         std::max(relativeError(ellipse.majorSigma, std::max(major, minor)),
                                  relativeError(ellipse.minorSigma, std::min(major, minor)))};
    });
    return sweep;
}

} // namespace trixel::sweeps
