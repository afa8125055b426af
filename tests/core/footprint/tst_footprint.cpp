// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/footprint/footprint.h"
#include "core/footprint/svd2.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <optional>
#include <random>
#include <vector>

using namespace trixel;

namespace {

using Corners = std::array<glm::vec3, 3>;

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kInf = std::numeric_limits<double>::infinity();
const Corners kRight{glm::vec3{0, 0, 0}, glm::vec3{1, 0, 0}, glm::vec3{0, 1, 0}};

double det(const Footprint& f)
{
    return f.w1.x * f.w2.y - f.w1.y * f.w2.x;
}

bool isFinite(const Footprint& f)
{
    return std::isfinite(f.w1.x) && std::isfinite(f.w1.y) && std::isfinite(f.w2.x) &&
           std::isfinite(f.w2.y);
}

bool isFinite(const FootprintEllipse& e)
{
    return std::isfinite(e.majorLength) && std::isfinite(e.minorLength) &&
           std::isfinite(glm::length(e.major)) && std::isfinite(glm::length(e.minor));
}

/// Where the ray through a pixel offset meets the plane, in uv.
std::optional<glm::dvec2> hit(const PixelRay& ray, const Corners& c, double dx, double dy)
{
    const glm::dvec3 d = ray.direction + dx * ray.perX + dy * ray.perY;
    const glm::dvec3 e1 = glm::dvec3(c[1]) - glm::dvec3(c[0]);
    const glm::dvec3 e2 = glm::dvec3(c[2]) - glm::dvec3(c[0]);
    const glm::dvec3 p = glm::cross(d, e2);
    const double scale = glm::dot(e1, p);
    const glm::dvec3 s = ray.origin - glm::dvec3(c[0]);
    const glm::dvec3 q = glm::cross(s, e1);
    if (glm::dot(e2, q) / scale <= 0) {
        return std::nullopt;
    }
    return glm::dvec2(glm::dot(s, p), glm::dot(d, q)) / scale;
}

struct Random
{
    std::mt19937 engine{7};
    double in(double low, double high)
    {
        return std::uniform_real_distribution<double>(low, high)(engine);
    }
    glm::dvec3 vec(double size) { return {in(-size, size), in(-size, size), in(-size, size)}; }
};

/// Straight-down view of the plane z = 0 from `height`, one pixel `step` apart at distance 1.
PixelRay downRay(double height, double step)
{
    return {{0.2, 0.3, height}, {0, 0, -1}, {step, 0, 0}, {0, -step, 0}};
}

/// A ray that meets z = 0 at an angle (radians), at distance 1.
PixelRay grazingRay(double angle, double step)
{
    const glm::dvec3 along(std::cos(angle), 0, -std::sin(angle));
    const glm::dvec3 up(std::sin(angle), 0, std::cos(angle));
    return {-along, along, {0, step, 0}, -step * up};
}

} // namespace

TEST(ScreenFootprint, straightViewIsThePixelItself)
{
    const Footprint f = screenFootprint(downRay(2, 0.01), kRight);
    EXPECT_NEAR(f.w1.x, 0.02, 1e-15);
    EXPECT_NEAR(f.w1.y, 0, 1e-15);
    EXPECT_NEAR(f.w2.x, 0, 1e-15);
    EXPECT_NEAR(f.w2.y, -0.02, 1e-15);
}

TEST(ScreenFootprint, equalsTheDerivativeOfTheHitPoint)
{
    Random random;
    int compared = 0;
    for (int k = 0; k < 2000; ++k) {
        const Corners c{
            glm::vec3(random.vec(1)), glm::vec3(random.vec(1)), glm::vec3(random.vec(1))};
        const PixelRay ray{random.vec(3), random.vec(1), random.vec(1e-3), random.vec(1e-3)};
        constexpr double h = 1e-3;
        const auto left = hit(ray, c, -h, 0);
        const auto right = hit(ray, c, h, 0);
        const auto up = hit(ray, c, 0, -h);
        const auto down = hit(ray, c, 0, h);
        const Footprint f = screenFootprint(ray, c, 1e6);
        const double size = glm::length(f.w1) + glm::length(f.w2);
        if (!left || !right || !up || !down || size > 0.5) {
            continue; // the difference quotient is not accurate there
        }
        ++compared;
        EXPECT_NEAR(glm::length((*right - *left) / (2 * h) - f.w1), 0, 1e-3 * size);
        EXPECT_NEAR(glm::length((*down - *up) / (2 * h) - f.w2), 0, 1e-3 * size);
    }
    EXPECT_GT(compared, 500);
}

TEST(ScreenFootprint, keepsItsAreaDownToAMillionthOfARadian)
{
    for (double angle = 1; angle > 1e-6; angle /= 3) {
        const double step = 1e-4 * angle * angle; // so that no limit applies
        const Footprint f = screenFootprint(grazingRay(angle, step), kRight);
        // Pixel area over the sine of the angle, at distance 1.
        const double area = step * step / std::sin(angle);
        EXPECT_NEAR(std::abs(det(f)) / area, 1, 1e-6) << angle;
        EXPECT_GT(std::abs(det(f)), 0) << angle;
    }
}

TEST(ScreenFootprint, atTheSilhouetteOnlyTheLongAxisIsLimited)
{
    const Footprint f = screenFootprint(grazingRay(1e-7, 1e-3), kRight, 64);
    const Svd2 svd = svd2(f.w1, f.w2);
    EXPECT_NEAR(svd.major, 64, 1e-9);
    EXPECT_NEAR(svd.minor, 1e-3, 1e-9);
    EXPECT_NEAR(std::abs(svd.majorTo.x), 1, 1e-6); // along the view
}

TEST(ScreenFootprint, growsSteadilyTowardsTheHorizonAndStaysWidestBeyondIt)
{
    double before = 0;
    for (double angle = 1; angle > 1e-12; angle /= 1.5) {
        const Footprint f = screenFootprint(grazingRay(angle, 1e-3), kRight, 64);
        const double size = svd2(f.w1, f.w2).major;
        EXPECT_GE(size, before * (1 - 1e-9)) << angle;
        EXPECT_LE(size, 64 * (1 + 1e-9));
        before = size;
    }
    for (const double z : {0.0, 1e-300, 0.1, 1.0}) {
        const PixelRay away{{0, 0, 1}, {1, 0, z}, {0, 1e-3, 0}, {0, 0, -1e-3}};
        const Footprint f = screenFootprint(away, kRight, 64);
        const Svd2 svd = svd2(f.w1, f.w2);
        EXPECT_DOUBLE_EQ(svd.major, 64);
        EXPECT_DOUBLE_EQ(svd.minor, 64);
    }
}

TEST(ScreenFootprint, sweepingThroughTheCameraPlaneStaysFiniteAndInOrder)
{
    for (int k = -1000; k <= 1000; ++k) {
        const double w = k / 1000.0;
        const PixelRay ray{{0.1, 0.2, w}, {0.3, 0.1, -w}, {1e-3, 0, 0}, {0, 1e-3, 0}};
        const Footprint f = screenFootprint(ray, kRight, 64);
        ASSERT_TRUE(isFinite(f)) << w;
        const Svd2 svd = svd2(f.w1, f.w2);
        EXPECT_LE(svd.minor, svd.major);
        EXPECT_LE(svd.major, 64 * (1 + 1e-12));
    }
}

TEST(ScreenFootprint, degenerateFacesGiveAZeroFootprint)
{
    const glm::vec3 p(0.1F, 0.2F, 0.3F);
    for (const Corners& c : {Corners{p, p, p},
                             Corners{p, p, glm::vec3(1)},
                             Corners{p, 2.0F * p, 4.0F * p},
                             Corners{p, glm::vec3(1), p}}) {
        const Footprint f = screenFootprint(downRay(5, 1e-3), c);
        EXPECT_EQ(f.w1, glm::dvec2(0));
        EXPECT_EQ(f.w2, glm::dvec2(0));
        EXPECT_TRUE(isFinite(ellipseOf({{1, 0}, {0, 1}}, c)));
    }
}

TEST(ScreenFootprint, everyInputGivesAFiniteResult)
{
    const std::vector<double> numbers{
        0, -0.0, 5e-324, 1e-300, 1e-30, 1, -1, 1e10, 1e30, -1e30, 1e300, kInf, -kInf, kNaN};
    Random random;
    const auto any = [&] {
        return numbers[static_cast<std::size_t>(random.in(0, 0.999) * double(numbers.size()))];
    };
    const auto anyVec = [&] { return glm::dvec3(any(), any(), any()); };
    for (int k = 0; k < 20000; ++k) {
        const PixelRay ray{anyVec(), anyVec(), anyVec(), anyVec()};
        const Corners wild{glm::vec3(anyVec()), glm::vec3(anyVec()), glm::vec3(anyVec())};
        for (const Corners& c : {kRight, wild}) {
            const Footprint f = screenFootprint(ray, c, k % 7 == 0 ? any() : 64);
            ASSERT_TRUE(isFinite(f));
            ASSERT_TRUE(isFinite(ellipseOf(f, c)));
        }
        const Footprint wildPrint{{any(), any()}, {any(), any()}};
        const FootprintEllipse e = ellipseOf(wildPrint, k % 2 == 0 ? kRight : wild);
        ASSERT_TRUE(isFinite(e));
        ASSERT_LE(e.minorLength, e.majorLength);
    }
}

TEST(EllipseOf, aSquareFootprintOnARightTriangleIsACircle)
{
    const FootprintEllipse e = ellipseOf({{0.2, 0}, {0, 0.2}}, kRight);
    EXPECT_NEAR(e.majorLength, 0.1, 1e-15);
    EXPECT_NEAR(e.minorLength, 0.1, 1e-15);
    EXPECT_NEAR(glm::length(e.major), 0.1, 1e-15);
    EXPECT_NEAR(e.anisotropy(), 1, 1e-12);
}

TEST(EllipseOf, halfAxesAreSquareRootsOfTheEigenvaluesOfTheCovariance)
{
    Random random;
    for (int k = 0; k < 500; ++k) {
        const Corners c{
            glm::vec3(random.vec(1)), glm::vec3(random.vec(1)), glm::vec3(random.vec(1))};
        const Footprint f{{random.in(-1, 1), random.in(-1, 1)},
                          {random.in(-1, 1), random.in(-1, 1)}};
        const FootprintEllipse e = ellipseOf(f, c);
        const glm::dvec3 e1 = glm::dvec3(c[1]) - glm::dvec3(c[0]);
        const glm::dvec3 e2 = glm::dvec3(c[2]) - glm::dvec3(c[0]);
        const auto world = [&](glm::dvec2 w) { return w.x * e1 + w.y * e2; };
        const glm::dvec3 p1 = world(f.w1);
        const glm::dvec3 p2 = world(f.w2);
        // Trace and determinant of ¼ (P1 P1ᵀ + P2 P2ᵀ) within the plane.
        const double trace = (glm::dot(p1, p1) + glm::dot(p2, p2)) / 4;
        const double root = glm::length(glm::cross(p1, p2)) / 4;
        EXPECT_NEAR(
            e.majorLength * e.majorLength + e.minorLength * e.minorLength, trace, 1e-9 * trace);
        EXPECT_NEAR(e.majorLength * e.minorLength, root, 1e-9 * trace);
        EXPECT_NEAR(glm::length(world(e.major)), e.majorLength, 1e-9 * e.majorLength);
        EXPECT_NEAR(glm::length(world(e.minor)), e.minorLength, 1e-6 * e.majorLength);
        EXPECT_NEAR(glm::dot(world(e.major), world(e.minor)), 0, 1e-9 * trace);
    }
}

TEST(EllipseOf, theMinorAxisKeepsItsDigitsForNearlyParallelVectors)
{
    for (double angle = 1; angle >= 1e-12; angle /= 10) {
        const Footprint f{{1, 0}, {std::cos(angle), std::sin(angle)}};
        const FootprintEllipse e = ellipseOf(f, kRight);
        const long double trace = 0.5L;
        const long double root = std::sin(static_cast<long double>(angle)) / 4;
        const long double major = (std::sqrt(trace + 2 * root) + std::sqrt(trace - 2 * root)) / 2;
        EXPECT_GT(e.minorLength, 0);
        EXPECT_NEAR(static_cast<double>(e.minorLength / (root / major)), 1, 1e-6) << angle;
        EXPECT_NEAR(glm::length(e.minor) / e.minorLength, 1, 1e-6) << angle;
    }
}

TEST(EllipseOf, hugeVectorsAreScaledDownAndNonFiniteOnesCountAsTheWidest)
{
    const double huge = ellipseOf({{1e300, 0}, {0, 1e200}}, kRight).majorLength;
    EXPECT_GT(huge, 1e5);
    EXPECT_DOUBLE_EQ(ellipseOf({{kNaN, 0}, {0, 1}}, kRight).majorLength, huge);
    EXPECT_DOUBLE_EQ(ellipseOf({{1, 0}, {0, kInf}}, kRight).minorLength, huge);
}

TEST(EllipseOf, exchangingNegatingOrRotatingTheVectorsChangesNothing)
{
    const Footprint f{{0.3, 0.1}, {-0.05, 0.2}};
    const Corners c{glm::vec3{0, 0, 0}, glm::vec3{1, 0.2F, 0}, glm::vec3{0.3F, 1, 0.4F}};
    const FootprintEllipse e = ellipseOf(f, c);
    const double s = std::sin(0.7);
    const double o = std::cos(0.7);
    for (const Footprint& other : {Footprint{f.w2, f.w1},
                                   Footprint{-f.w1, f.w2},
                                   Footprint{o * f.w1 + s * f.w2, -s * f.w1 + o * f.w2}}) {
        const FootprintEllipse b = ellipseOf(other, c);
        EXPECT_NEAR(b.majorLength, e.majorLength, 1e-12);
        EXPECT_NEAR(b.minorLength, e.minorLength, 1e-12);
        EXPECT_NEAR(std::abs(glm::dot(glm::normalize(b.major), glm::normalize(e.major))), 1, 1e-12);
    }
}

TEST(Svd2, putsAMatrixBackTogether)
{
    Random random;
    for (int k = 0; k < 1000; ++k) {
        const double size = std::pow(10, random.in(-200, 200));
        const glm::dvec2 c1(size * random.in(-1, 1), size * random.in(-1, 1));
        const glm::dvec2 c2(size * random.in(-1, 1), size * random.in(-1, 1));
        const Svd2 s = svd2(c1, c2);
        const auto apply = [&](glm::dvec2 v) { return c1 * v.x + c2 * v.y; };
        EXPECT_NEAR(glm::length((apply(s.majorFrom) - s.major * s.majorTo) / size), 0, 1e-14);
        EXPECT_NEAR(glm::length((apply(s.minorFrom) - s.minor * s.minorTo) / size), 0, 1e-14);
    }
}

TEST(Svd2, directionsHaveUnitLengthForACircleAndForNothing)
{
    for (const double size : {0.0, 5e-324, 1.0, 1e300}) {
        const Svd2 s = svd2({size, 0}, {0, size});
        EXPECT_NEAR(glm::length(s.majorTo), 1, 1e-12);
        EXPECT_NEAR(glm::length(s.minorTo), 1, 1e-12);
        EXPECT_DOUBLE_EQ(s.major, size);
        EXPECT_DOUBLE_EQ(s.minor, size);
    }
}
