// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/footprint/chain_rule.h"
#include "core/footprint/ellipse_report.h"
#include "core/footprint/limit.h"
#include "core/footprint/projected_face.h"
#include "core/footprint/screen_derivatives.h"
#include "core/footprint/sources.h"
#include "core/footprint/svd2.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/ext/matrix_clip_space.hpp>
#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>
#include <glm/mat4x4.hpp>
#include <limits>
#include <numbers>
#include <random>

using namespace trixel;

namespace {

using Corners = std::array<glm::vec3, 3>;

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kInf = std::numeric_limits<double>::infinity();
const Corners kEquilateral{glm::vec3{0, 0, 0},
                           glm::vec3{1, 0, 0},
                           glm::vec3{0.5F, static_cast<float>(std::numbers::sqrt3 / 2), 0}};

struct Random
{
    std::mt19937 engine{11};
    double in(double low, double high)
    {
        return std::uniform_real_distribution<double>(low, high)(engine);
    }
    glm::dvec2 vec2(double size) { return {in(-size, size), in(-size, size)}; }
    glm::dvec3 vec3(double size) { return {in(-size, size), in(-size, size), in(-size, size)}; }
};

double distance(const Footprint& a, const Footprint& b)
{
    return glm::length(a.w1 - b.w1) + glm::length(a.w2 - b.w2);
}

double size(const Footprint& f)
{
    return glm::length(f.w1) + glm::length(f.w2);
}

bool isFinite(const Footprint& f)
{
    return std::isfinite(f.w1.x) && std::isfinite(f.w1.y) && std::isfinite(f.w2.x) &&
           std::isfinite(f.w2.y);
}

/// Pixels of a 1000 x 800 view from a random place towards the origin.
glm::dmat4 viewToPixels(Random& random)
{
    const glm::dvec3 eye = 4.0 * glm::normalize(random.vec3(1) + glm::dvec3(0, 0, 1.5));
    const glm::dmat4 view = glm::lookAt(eye, glm::dvec3(0), glm::dvec3(0, 1, 0));
    const glm::dmat4 clip = glm::perspective(0.7, 1.25, 0.1, 100.0);
    glm::dmat4 pixels(1);
    pixels[0][0] = 500;
    pixels[1][1] = -400;
    pixels[3][0] = 500;
    pixels[3][1] = 400;
    return pixels * clip * view;
}

} // namespace

TEST(FootprintSources, textureAlignedIsTheBoxThatWasAskedFor)
{
    const Footprint f = textureAligned(0.25, 0.5);
    EXPECT_EQ(f.w1, glm::dvec2(0.25, 0));
    EXPECT_EQ(f.w2, glm::dvec2(0, 0.5));
}

TEST(FootprintSources, draggedHalfAxesAreTheEllipsesOwn)
{
    // At right angles in the equilateral plane: (1,0) and (-1,2)/√3.
    const glm::dvec2 across = glm::dvec2(-1, 2) / std::numbers::sqrt3 * 0.1;
    const FootprintEllipse e = ellipseOf(fromHalfAxes({0.3, 0}, across), kEquilateral);
    EXPECT_NEAR(e.majorLength, 0.3, 1e-7);
    EXPECT_NEAR(e.minorLength, 0.1, 1e-7);
    EXPECT_NEAR(glm::length(glm::abs(e.major) - glm::dvec2(0.3, 0)), 0, 1e-7);
}

TEST(FootprintSources, numbersGiveWidthAnisotropyAndAngle)
{
    for (double angle = 0; angle < 3; angle += 0.1) {
        const FootprintEllipse e = ellipseOf(equilateralFootprint(0.02, 7, angle), kEquilateral);
        EXPECT_NEAR(e.minorLength, 0.01, 1e-8);
        EXPECT_NEAR(e.anisotropy(), 7, 1e-5);
        const glm::dvec2 plane(e.major.x + e.major.y / 2, e.major.y * std::numbers::sqrt3 / 2);
        const glm::dvec2 along(std::cos(angle), std::sin(angle));
        EXPECT_NEAR(std::abs(glm::dot(plane, along)), e.majorLength, 1e-7);
    }
}

TEST(ScreenDerivatives, equalTheTextbooksInverseWhereThatNeedsNoLimit)
{
    Random random;
    for (int k = 0; k < 2000; ++k) {
        const double scale = std::pow(10, random.in(0, 6));
        const ScreenDerivatives d{random.vec2(scale), random.vec2(scale)};
        const Footprint textbook = inverseJacobian(d);
        if (size(textbook) < 30) {
            EXPECT_LE(distance(footprintOf(d), textbook), 1e-12 * size(textbook));
        }
    }
}

TEST(ScreenDerivatives, limitOnlyTheAxesThatAreLonger)
{
    // 100 pixels along u, next to none along v.
    const Footprint f = footprintOf({{60, 80}, {0.8e-9, -0.6e-9}}, 64);
    const Svd2 svd = svd2(f.w1, f.w2);
    EXPECT_NEAR(svd.major, 64, 1e-12);
    EXPECT_NEAR(svd.minor, 0.01, 1e-12);
    EXPECT_NEAR(std::abs(svd.majorTo.y), 1, 1e-12);
}

TEST(ScreenDerivatives, ofAnySizeGiveAnOrderedFiniteFootprint)
{
    Random random;
    for (int k = 0; k < 20000; ++k) {
        const auto any = [&] {
            const double choice = random.in(0, 20);
            return choice < 1   ? kNaN
                   : choice < 2 ? kInf
                   : choice < 4
                       ? 0.0
                       : std::copysign(std::pow(10, random.in(-323, 308)), random.in(-1, 1));
        };
        const Footprint f = footprintOf({{any(), any()}, {any(), any()}}, 64);
        ASSERT_TRUE(isFinite(f));
        ASSERT_LE(svd2(f.w1, f.w2).major, 64 * (1 + 1e-12));
    }
}

TEST(ChainRule, isTheProductOfTheTwoDerivatives)
{
    // s = 2u + v, t = 3v - u
    const Footprint f = chained({{0.1, 0.2}, {-0.3, 0.4}}, {{2, -1}, {1, 3}});
    EXPECT_NEAR(f.w1.x, 0.4, 1e-15);
    EXPECT_NEAR(f.w1.y, 0.5, 1e-15);
    EXPECT_NEAR(f.w2.x, -0.2, 1e-15);
    EXPECT_NEAR(f.w2.y, 1.5, 1e-15);
}

TEST(ChainRule, undoesAChangeOfParameters)
{
    Random random;
    for (int k = 0; k < 500; ++k) {
        const ScreenDerivatives inTexture{random.vec2(300), random.vec2(300)};
        const TextureDerivatives map{random.vec2(1), random.vec2(1)};
        // The renderer's derivatives by (u,v), through (s,t).
        const ScreenDerivatives inUv{inTexture.perU * map.perU.x + inTexture.perV * map.perU.y,
                                     inTexture.perU * map.perV.x + inTexture.perV * map.perV.y};
        const Footprint direct = inverseJacobian(inTexture);
        const Footprint chain = chained(inverseJacobian(inUv), map);
        EXPECT_LE(distance(direct, chain), 1e-9 * size(direct) + 1e-12);
    }
}

TEST(ProjectedFace, agreesWithTheRayOfTheSamePixel)
{
    Random random;
    int compared = 0;
    for (int k = 0; k < 300; ++k) {
        const glm::dmat4 toPixels = viewToPixels(random);
        const Corners c{
            glm::vec3(random.vec3(1)), glm::vec3(random.vec3(1)), glm::vec3(random.vec3(1))};
        const glm::dvec2 uv(0.3, 0.4);
        const ProjectedFace face = projectedFace(toPixels, c);
        const auto seen = footprintOf(face, uv);
        ASSERT_TRUE(seen);
        // The ray through that pixel, from the inverse matrix.
        const glm::dvec3 p = face.at(uv);
        const auto unprojected = [&](double x, double y, double depth) {
            const glm::dvec4 q = glm::inverse(toPixels) * glm::dvec4(x, y, depth, 1);
            return glm::dvec3(q) / q.w;
        };
        const glm::dvec2 pixel(p.x / p.z, p.y / p.z);
        const auto towards = [&](double dx, double dy) {
            return unprojected(pixel.x + dx, pixel.y + dy, 1) -
                   unprojected(pixel.x + dx, pixel.y + dy, -1);
        };
        PixelRay ray;
        ray.direction = towards(0, 0);
        ray.perX = towards(1, 0) - towards(0, 0);
        ray.perY = towards(0, 1) - towards(0, 0);
        const glm::dvec4 eye = glm::inverse(toPixels) * glm::dvec4(0, 0, 1, 0);
        ray.origin = glm::dvec3(eye) / eye.w;
        const Footprint byRay = screenFootprint(ray, c);
        if (size(byRay) < 1) {
            ++compared;
            EXPECT_LE(distance(*seen, byRay), 1e-5 * size(byRay));
        }
    }
    EXPECT_GT(compared, 200);
}

TEST(ProjectedFace, equalsTheQuotientRuleInFrontOfTheCamera)
{
    Random random;
    for (int k = 0; k < 1000; ++k) {
        ProjectedFace face{random.vec3(500), random.vec3(300), random.vec3(300)};
        face.origin.z = random.in(0.5, 2);
        face.perU.z = random.in(-0.2, 0.2);
        face.perV.z = random.in(-0.2, 0.2);
        const glm::dvec2 uv(0.2, 0.3);
        const Footprint textbook = inverseJacobian(screenDerivatives(face, uv));
        const auto robust = footprintOf(face, uv);
        ASSERT_TRUE(robust);
        if (size(textbook) < 30) {
            EXPECT_LE(distance(*robust, textbook), 1e-8 * size(textbook));
        }
    }
}

TEST(ProjectedFace, behindTheCameraOrNearerThanTheClipPlaneNothingIsSeen)
{
    const ProjectedFace face{{0, 0, 1}, {100, 0, -1}, {0, 100, 0}};
    EXPECT_TRUE(footprintOf(face, {0.5, 0}));
    EXPECT_FALSE(footprintOf(face, {1.0, 0}));
    EXPECT_FALSE(footprintOf(face, {1.5, 0}));
    EXPECT_FALSE(footprintOf(face, {0.5, 0}, 64, 0.6));
    EXPECT_FALSE(footprintOf(face, {kNaN, 0}));
}

TEST(LimitedTo, keepsShortFootprintsAndDirectionsOfLongOnes)
{
    const Footprint f{{3, 4}, {-0.4, 0.3}};
    EXPECT_EQ(distance(limitedTo(f, 5.1), f), 0);
    const Footprint cut = limitedTo(f, 1);
    EXPECT_NEAR(glm::length(cut.w1 - glm::dvec2(0.6, 0.8)), 0, 1e-12);
    EXPECT_NEAR(glm::length(cut.w2 - f.w2), 0, 1e-12);
    EXPECT_EQ(limitedTo({{kInf, 0}, {0, 1}}, 2).w2, glm::dvec2(0, 2));
    EXPECT_TRUE(isFinite(limitedTo({{1e308, 1e308}, {-1e308, 1e308}}, 2)));
}

TEST(EllipseReport, tellsAreaConditionAndTheLevelWhoseTexelsAreAsWide)
{
    const EllipseReport report =
        describe(equilateralFootprint(1.0 / 16, 4, 0.3), kEquilateral, Level(7));
    EXPECT_NEAR(report.condition, 4, 1e-5);
    EXPECT_NEAR(report.area, std::numbers::pi / 32 / 8, 1e-8);
    EXPECT_NEAR(report.width, 8, 1e-5);
    EXPECT_NEAR(report.level, 4, 1e-5);
}

/// What has no length says nothing of how long the face's texels are.
TEST(EllipseReport, anEdgeWithoutLengthIsLeftOut)
{
    std::array<glm::vec3, 3> corners = kEquilateral;
    corners[1] = corners[0];
    const Footprint footprint = textureAligned(0.25, 0.25);
    const EllipseReport report = describe(footprint, corners, Level(5));
    const EllipseReport wanted = describe(footprint, corners, Level(5), 0); // edges are 1 long
    EXPECT_TRUE(std::isfinite(report.width));
    EXPECT_NEAR(report.width, wanted.width, 1e-5);
    EXPECT_NEAR(report.level, wanted.level, 1e-5);
    corners[2] = corners[0];
    EXPECT_TRUE(std::isfinite(describe(footprint, corners, Level(5)).width));
}

TEST(EllipseReport, levelStaysBetweenTheBaseAndTheCoarsest)
{
    EXPECT_EQ(describe(textureAligned(50, 50), kEquilateral, Level(5)).level, 0);
    EXPECT_EQ(describe(textureAligned(1e-9, 1e-9), kEquilateral, Level(5)).level, 5);
    const EllipseReport nothing = describe({}, kEquilateral, Level(5));
    EXPECT_EQ(nothing.level, 5);
    EXPECT_EQ(nothing.condition, 1);
    EXPECT_EQ(describe({{1, 0}, {2, 0}}, kEquilateral, Level(5)).condition, kInf);
}
