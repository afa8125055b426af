// SPDX-License-Identifier: GPL-3.0-or-later
//
// Footprints of pixels: silhouettes, the plane of the camera, seams between pieces of an atlas.
#include "core/footprint/footprint.h"
#include "core/footprint/projected_face.h"
#include "core/footprint/screen_derivatives.h"
#include "core/study/stability/naive_forms.h"
#include "core/study/stability/sweeps.h"
#include "core/study/stability/truth.h"

#include <array>
#include <glm/geometric.hpp>
#include <numbers>

namespace trixel::sweeps {

namespace {

/// Errors of the two lengths, relative to what they should be.
double lengthsError(const Footprint& found, long double major, long double minor)
{
    const LongLengths lengths = lengthsOf(found);
    return worse(relativeError(static_cast<double>(lengths.major), major),
                 relativeError(static_cast<double>(lengths.minor), minor));
}

/// Rotation, anisotropic scale, rotation: a view of a plane in any direction.
ScreenDerivatives tilted(double screenTurn, double faceTurn, double size, double squash)
{
    const glm::dvec2 a(std::cos(screenTurn), std::sin(screenTurn));
    const glm::dvec2 b(-a.y, a.x);
    const double c = std::cos(faceTurn);
    const double s = std::sin(faceTurn);
    return {size * (c * a - s * squash * b), size * (s * a + c * squash * b)};
}

/// Error of both lengths relative to the longer one: a footprint of four numbers cannot hold a
/// minor axis below their rounding.
double projectedError(const std::optional<Footprint>& found, long double major, long double minor)
{
    if (!found) {
        return kNoAnswer;
    }
    constexpr long double kSmallest = 1e-300L; // below it numbers lose digits of themselves
    const LongLengths lengths = lengthsOf(*found);
    const long double off =
        std::max(std::abs(lengths.major - major), std::abs(lengths.minor - minor));
    const auto error = static_cast<double>(off / std::max(major, kSmallest));
    return std::isfinite(error) ? error : kNoAnswer;
}

/// Two faces of the plane z = 0 in a view, each with a place of its own in an atlas.
struct AtlasView
{
    using Corners = std::array<glm::vec3, 3>;
    std::array<Corners, 2> faces{
        Corners{glm::vec3{0, 0, 0}, glm::vec3{1, 0, 0}, glm::vec3{0, 1, 0}},
        Corners{glm::vec3{1, 1, 0}, glm::vec3{0, 1, 0}, glm::vec3{1, 0, 0}}};
    std::array<glm::dvec2, 2> origins{glm::dvec2{0, 0}, glm::dvec2{5, 3}};

    /// The pixel that is so many pixels to the right of the seam.
    PixelRay ray(double pixels) const
    {
        constexpr double kPixel = 1.0 / 64;
        const glm::dvec3 eye(0.4, 0.3, 2);
        const glm::dvec3 seam(0.55, 0.45, 0);
        const glm::dvec3 perX(kPixel, 0.2 * kPixel, 0);
        return {eye, seam + pixels * perX - eye, perX, {-0.1 * kPixel, kPixel, 0}};
    }

    static LongVec2 hit(const PixelRay& ray, const Corners& face, const LongVec3& d)
    {
        const LongVec3 e1 = LongVec3(face[1]) - LongVec3(face[0]);
        const LongVec3 e2 = LongVec3(face[2]) - LongVec3(face[0]);
        const LongVec3 s = LongVec3(ray.origin) - LongVec3(face[0]);
        const LongVec3 p = cross(d, e2);
        return LongVec2(dot(s, p), dot(d, cross(s, e1))) / dot(e1, p);
    }
    std::size_t faceAt(const PixelRay& ray, const glm::dvec3& d) const
    {
        const LongVec2 uv = hit(ray, faces[0], LongVec3(d));
        return uv.x + uv.y <= 1 ? 0 : 1;
    }
    glm::dvec2 atlas(const PixelRay& ray, const glm::dvec3& d) const
    {
        const std::size_t face = faceAt(ray, d);
        return glm::dvec2(hit(ray, faces[face], LongVec3(d))) + origins[face];
    }
    Footprint truth(const PixelRay& ray, const Corners& face) const
    {
        constexpr long double kStep = 1e-5L;
        const auto derivative = [&](const glm::dvec3& per) {
            const LongVec3 d(ray.direction);
            const LongVec3 step = kStep * LongVec3(per);
            return glm::dvec2((hit(ray, face, d + step) - hit(ray, face, d - step)) / (2 * kStep));
        };
        return {derivative(ray.perX), derivative(ray.perY)};
    }
};

double vectorsError(const Footprint& found, const Footprint& truth)
{
    const double error = glm::length(found.w1 - truth.w1) / glm::length(truth.w1) +
                         glm::length(found.w2 - truth.w2) / glm::length(truth.w2);
    return std::isfinite(error) ? error : kNoAnswer;
}

} // namespace

StabilitySweep silhouette()
{
    StabilitySweep sweep{
        .name = "silhouette",
        .title = "Silhouettes: det J \u2192 0",
        .hazard = "The inverse Jacobian divides by a determinant without digits, and by 0.",
        .property = "minor <= major <= Lmax, both finite and right, directions kept.",
        .axisTitle = "sine of the view's angle to the face",
        .errorTitle = "relative error of the axes",
        .bound = 1e-6};
    sweep.values = geometric(1, 1e-18, 0.1, {0});
    addCurves(sweep, "inverse Jacobian", "singular values, limited", [](double sine) {
        constexpr double kLimit = 64;
        ErrorPair errors;
        SweepRandom random;
        for (int k = 0; k < 64; ++k) {
            const double turn = random.in(0, 2 * std::numbers::pi);
            const ScreenDerivatives d =
                tilted(turn, random.in(0, 2 * std::numbers::pi), random.in(1, 1000), sine);
            const LongLengths screen{LongVec2(d.perU), LongVec2(d.perV)};
            const auto limited = [&](long double length) {
                return 1 / std::max(length, 1 / static_cast<long double>(kLimit));
            };
            errors.add(
                lengthsError(inverseJacobian(d), 1 / screen.minor, 1 / screen.major),
                lengthsError(footprintOf(d, kLimit), limited(screen.minor), limited(screen.major)));
        }
        return errors;
    });
    return sweep;
}

StabilitySweep cameraPlane()
{
    StabilitySweep sweep{
        .name = "camera-plane",
        .title = "Through the plane of the camera",
        .hazard = "Dividing by w\u00B2 gives a mirrored footprint behind the camera and 0/0 on "
                  "its plane.",
        .property = "In front, both axes are right relative to the longer; at w <= 0 there is no "
                    "footprint.",
        .axisTitle = "w",
        .axis = SweepAxis::Listed,
        .errorTitle = "error over the long axis",
        .bound = 1e-6};
    for (const double w : {1.0,
                           0.1,
                           1e-2,
                           1e-4,
                           1e-6,
                           1e-8,
                           1e-12,
                           1e-16,
                           1e-40,
                           1e-100,
                           1e-200,
                           5e-324,
                           0.0,
                           -5e-324,
                           -1e-100,
                           -1e-8,
                           -1e-2,
                           -1.0}) {
        sweep.values.push_back(sweepValue(w));
    }
    addCurves(sweep, "quotient rule, inverted", "homogeneous, clipped", [](double w) {
        const ProjectedFace face{{200, 100, w}, {300, 40, 0.5}, {-60, 280, -0.3}};
        const auto textbook = naive::footprintOf(face, {0, 0});
        const auto robust = footprintOf(face, {0, 0}, 1e6);
        if (w <= 0) {
            return ErrorPair{textbook ? kNoAnswer : 0, robust ? kNoAnswer : 0};
        }
        const LongVec3 p(face.origin);
        const auto scaled = [&](const glm::dvec3& d) {
            return LongVec2(d.x * p.z - p.x * d.z, d.y * p.z - p.y * d.z);
        };
        const LongLengths screen{scaled(face.perU), scaled(face.perV)};
        const long double volume =
            std::abs(dot(p, cross(LongVec3(face.perU), LongVec3(face.perV))));
        const long double major = p.z * screen.major / volume;
        const long double minor = p.z * p.z / screen.major;
        return ErrorPair{projectedError(textbook, major, minor),
                         projectedError(robust, major, minor)};
    });
    return sweep;
}

StabilitySweep atlasSeam()
{
    StabilitySweep sweep{
        .name = "atlas-seam",
        .title = "Pixels across a seam of the atlas",
        .hazard = "Neighbouring pixels lie far apart in the atlas, and their difference is taken "
                  "for a footprint.",
        .property = "W is the derivative on the face that the pixel sees.",
        .axisTitle = "pixels from the seam",
        .axis = SweepAxis::Linear,
        .errorTitle = "relative error of W",
        .bound = 1e-2};
    for (double pixels = -4.5; pixels <= 4.5; pixels += 0.5) {
        sweep.values.push_back(sweepValue(pixels));
    }
    addCurves(sweep, "difference of pixels", "derivative per face", [](double pixels) {
        const AtlasView view;
        const PixelRay ray = view.ray(pixels);
        const auto& face = view.faces[view.faceAt(ray, ray.direction)];
        const glm::dvec2 here = view.atlas(ray, ray.direction);
        const Footprint textbook{view.atlas(ray, ray.direction + ray.perX) - here,
                                 view.atlas(ray, ray.direction + ray.perY) - here};
        const Footprint truth = view.truth(ray, face);
        return ErrorPair{vectorsError(textbook, truth),
                         vectorsError(screenFootprint(ray, face), truth)};
    });
    return sweep;
}

} // namespace trixel::sweeps
