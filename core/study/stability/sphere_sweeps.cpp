// SPDX-License-Identifier: GPL-3.0-or-later
//
// The sphere map: its seam, its quadrants, its poles.
#include "core/mapping/sphere.h"
#include "core/study/stability/naive_forms.h"
#include "core/study/stability/sweeps.h"
#include "core/study/stability/truth.h"

#include <numbers>

namespace trixel::sweeps {

namespace {

constexpr long double kPi = std::numbers::pi_v<long double>;

LongVec3 directionOf(long double u, long double v)
{
    const long double longitude = (u - 0.25L) * 2 * kPi;
    const long double latitude = (v - 0.5L) * kPi;
    return {std::cos(latitude) * std::cos(longitude),
            std::sin(latitude),
            std::cos(latitude) * std::sin(longitude)};
}

/// Lengths of (W1, W2) along u and along v.
struct Extents
{
    long double u = 0;
    long double v = 0;
};

Extents extentsOf(const Footprint& f)
{
    return {std::hypot(f.w1.x, f.w2.x), std::hypot(f.w1.y, f.w2.y)};
}

/// Of the direction and its changes as rounded, limited to one period and the height.
Extents trueExtents(const glm::dvec3& direction, const glm::dvec3& a, const glm::dvec3& b)
{
    const LongVec3 d(direction);
    const long double axis = std::hypot(d.x, d.z);
    const auto derivative = [&](const LongVec3& c) {
        const long double around = axis > 0 ? (d.x * c.z - d.z * c.x) / axis / axis : INFINITY;
        const long double outwards =
            axis > 0 ? (d.x * c.x + d.z * c.z) / axis : std::hypot(c.x, c.z);
        return LongVec2(around / (2 * kPi), (axis * c.y - d.y * outwards) / dot(d, d) / kPi);
    };
    const LongVec2 first = derivative(LongVec3(a));
    const LongVec2 second = derivative(LongVec3(b));
    return {std::min(std::hypot(first.x, second.x), 1.0L),
            std::min(std::hypot(first.y, second.y), 1.0L)};
}

double extentsError(const Footprint& found, const Extents& truth)
{
    const Extents extents = extentsOf(found);
    return worse(relativeError(static_cast<double>(extents.u), truth.u),
                 relativeError(static_cast<double>(extents.v), truth.v));
}

/// |a - b| modulo 1.
double periodicError(double found, long double expected)
{
    if (!std::isfinite(found)) {
        return kNoAnswer;
    }
    const long double off = found - expected;
    return static_cast<double>(std::abs(off - std::round(off)));
}

double mapError(glm::dvec2 found, const LongVec2& expected)
{
    const double offV = static_cast<double>(std::abs(found.y - expected.y));
    return worse(periodicError(found.x, expected.x), offV);
}

} // namespace

StabilitySweep sphereSeam()
{
    StabilitySweep sweep{.name = "sphere-seam",
                         .title = "Pixels across the seam of the sphere map",
                         .hazard = "Across u = 0 the difference of coordinates is a whole period.",
                         .property = "W is the derivative, seam or not.",
                         .axisTitle = "pixels from the seam",
                         .axis = SweepAxis::Linear,
                         .errorTitle = "relative error of W",
                         .bound = 1e-2};
    for (double pixels = -4.5; pixels <= 4.5; pixels += 0.5) {
        sweep.values.push_back(sweepValue(pixels));
    }
    addCurves(sweep, "difference of pixels", "derivative by cross product", [](double pixels) {
        constexpr long double kPixel = 1.0L / 1024;
        ErrorPair errors;
        for (const long double v : {0.3L, 0.5L, 0.8L}) {
            const long double u = static_cast<long double>(pixels) * kPixel;
            const LongVec3 here = directionOf(u, v);
            const glm::dvec3 d(here);
            const glm::dvec3 a(directionOf(u + kPixel, v) - here);
            const glm::dvec3 b(directionOf(u, v + kPixel) - here);
            const Extents truth = trueExtents(d, a, b);
            errors.add(extentsError(naive::sphereDifferences(d, a, b), truth),
                       extentsError(sphereFootprint(d, a, b), truth));
        }
        return errors;
    });
    return sweep;
}

StabilitySweep sphereQuadrants()
{
    StabilitySweep sweep{
        .name = "sphere-quadrants",
        .title = "Once round the sphere",
        .hazard = "atan(z/x) and atan(y/x) forget the quadrant and are 0/0 on the axis.",
        .property = "Coordinates are those of longitude and latitude, modulo a period.",
        .axisTitle = "longitude (degrees)",
        .axis = SweepAxis::Linear,
        .errorTitle = "error of (u,v)",
        .bound = 1e-6};
    for (int degrees = 0; degrees <= 360; degrees += 10) {
        sweep.values.push_back(sweepValue(degrees));
    }
    addCurves(sweep, "atan(z/x), atan(y/x)", "atan2", [](double degrees) {
        ErrorPair errors;
        for (const long double v : {0.1L, 0.4L, 0.5L, 0.75L}) {
            const LongVec2 uv(static_cast<long double>(degrees) / 360, v);
            glm::dvec3 d(directionOf(uv.x, uv.y));
            for (int axis = 0; axis < 3; ++axis) {
                d[axis] = std::abs(d[axis]) < 1e-15 ? 0 : d[axis]; // on the axes exactly
            }
            errors.add(mapError(naive::sphereUv(d), uv), mapError(sphereUv(d), uv));
        }
        return errors;
    });
    return sweep;
}

StabilitySweep spherePole()
{
    StabilitySweep sweep{.name = "sphere-pole",
                         .title = "Towards a pole of the sphere map",
                         .hazard =
                             "The change of longitude grows without bound and is 0/0 at the pole.",
                         .property = "W covers at most one period, and is right until then.",
                         .axisTitle = "angle from the pole (rad)",
                         .errorTitle = "relative error of W",
                         .bound = 1e-6};
    sweep.values = geometric(1, 1e-15, 0.1, {1e-200, 0});
    addCurves(sweep, "derivative as it stands", "limited to a period", [](double angle) {
        ErrorPair errors;
        for (const double longitude : {0.3, 2.0, 4.5}) {
            const double axis = std::sin(angle);
            const glm::dvec3 d(
                axis * std::cos(longitude), std::cos(angle), axis * std::sin(longitude));
            const glm::dvec3 a(1e-3, 2e-4, 0);
            const glm::dvec3 b(-1e-4, 1e-4, 2e-3);
            const Extents truth = trueExtents(d, a, b);
            errors.add(extentsError(naive::sphereFootprint(d, a, b), truth),
                       extentsError(sphereFootprint(d, a, b), truth));
        }
        return errors;
    });
    return sweep;
}

} // namespace trixel::sweeps
