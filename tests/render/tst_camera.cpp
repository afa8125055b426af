// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/camera.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec4.hpp>
#include <limits>
#include <numbers>

using namespace trixel;
using namespace trixel::render;

namespace {

Camera someCamera()
{
    Camera camera;
    camera.setViewport(1600, 900);
    camera.setScene({-1, -1, -1}, {1, 1, 1});
    camera.setPose({{0.1, 0.2, -0.3}, 4, 0.7, 0.4});
    return camera;
}

glm::dvec2 onScreen(const Camera& camera, glm::dvec3 point)
{
    const glm::vec4 clip = camera.projection() * camera.view() * glm::vec4(glm::vec3(point), 1);
    const glm::dvec3 ndc = glm::dvec3(clip) / double(clip.w);
    return {(ndc.x * 0.5 + 0.5) * camera.viewport().x, (0.5 - ndc.y * 0.5) * camera.viewport().y};
}

void expectNear(glm::dvec2 a, glm::dvec2 b, double tolerance)
{
    EXPECT_NEAR(a.x, b.x, tolerance);
    EXPECT_NEAR(a.y, b.y, tolerance);
}

} // namespace

TEST(Camera, projectAgreesWithTheMatrices)
{
    const Camera camera = someCamera();
    for (const glm::dvec3 p : {glm::dvec3(0), glm::dvec3(0.5, -0.3, 0.8), glm::dvec3(-1, 1, -1)}) {
        expectNear(*camera.project(p), onScreen(camera, p), 1e-2);
    }
}

TEST(Camera, thePixelRayPassesThroughWhatIsProjectedThere)
{
    const Camera camera = someCamera();
    const glm::dvec3 point(0.5, -0.3, 0.8);
    const PixelRay ray = camera.pixelRay(*camera.project(point));
    EXPECT_NEAR(
        glm::length(glm::cross(glm::normalize(ray.direction), point - ray.origin)), 0, 1e-9);
    EXPECT_GT(glm::dot(ray.direction, point - ray.origin), 0);
}

TEST(Camera, thePixelRayChangesAsItsDerivativesSay)
{
    const Camera camera = someCamera();
    const PixelRay a = camera.pixelRay({300.5, 200.5});
    const PixelRay b = camera.pixelRay({307.5, 196.5});
    EXPECT_NEAR(glm::length(a.direction + 7.0 * a.perX - 4.0 * a.perY - b.direction), 0, 1e-12);
}

TEST(Camera, nothingIsProjectedFromBehind)
{
    const Camera camera = someCamera();
    EXPECT_FALSE(camera.project(camera.eye() - camera.forward()));
    EXPECT_FALSE(camera.project(camera.eye()));
}

TEST(Camera, framingShowsTheWholeBoxAndFillsThePicture)
{
    for (const glm::ivec2 size : {glm::ivec2(1600, 900), glm::ivec2(300, 900)}) {
        Camera camera = someCamera();
        camera.setViewport(size.x, size.y);
        const glm::dvec3 low(-1, -0.5, -0.25);
        const glm::dvec3 high(2, 1, 0.5);
        camera.setScene(glm::vec3(low), glm::vec3(high));
        camera.frame(glm::vec3(low), glm::vec3(high));
        double reach = 0;
        for (int k = 0; k < 8; ++k) {
            const glm::dvec3 corner(
                k & 1 ? high.x : low.x, k & 2 ? high.y : low.y, k & 4 ? high.z : low.z);
            const glm::dvec2 p = *camera.project(corner) / glm::dvec2(size);
            EXPECT_TRUE(p.x > 0 && p.x < 1 && p.y > 0 && p.y < 1);
            reach = std::max({reach, std::abs(p.x - 0.5), std::abs(p.y - 0.5)});
        }
        EXPECT_NEAR(reach, 0.45, 1e-3);
    }
}

TEST(Camera, framingAPointKeepsADistance)
{
    Camera camera = someCamera();
    camera.frame({0.5F, 0.5F, 0.5F}, {0.5F, 0.5F, 0.5F});
    EXPECT_GT(camera.pose().distance, 0.01);
    EXPECT_LT(camera.pose().distance, 1);
}

TEST(Camera, panningMovesTheTargetWithThePointer)
{
    Camera camera = someCamera();
    const glm::dvec3 target = camera.pose().target;
    const glm::dvec2 before = *camera.project(target);
    camera.pan({120, -45});
    expectNear(*camera.project(target), before + glm::dvec2(120, -45), 1e-6);
}

TEST(Camera, zoomingTowardsAPositionKeepsWhatIsThere)
{
    Camera camera = someCamera();
    const glm::dvec2 position(1200, 300);
    // The point of the target's plane that is seen there.
    const PixelRay ray = camera.pixelRay(position);
    const glm::dvec3 point = ray.origin + ray.direction * camera.pose().distance;
    camera.zoomTowards(0.5, position);
    EXPECT_NEAR(camera.pose().distance, 2, 1e-12);
    expectNear(*camera.project(point), position, 1e-6);
}

TEST(Camera, orbitingKeepsTheTargetInTheMiddleAndThePoleUpright)
{
    Camera camera = someCamera();
    const glm::dvec3 target = camera.pose().target;
    camera.orbit({10'000, 10'000});
    expectNear(*camera.project(target), {800, 450}, 1e-6);
    EXPECT_LT(camera.pose().pitch, std::numbers::pi / 2);
    const glm::dvec2 above = *camera.project(target + glm::dvec3(0, 0.1, 0));
    EXPECT_LE(above.y, 450);
}

TEST(Camera, orbitTurnsTheSurfaceWithThePointer)
{
    Camera camera = someCamera();
    camera.setPose({{0, 0, 0}, 4, 0, 0});
    const glm::dvec3 front(0, 0, 1); // nearest to the camera
    camera.orbit({50, 30});
    const glm::dvec2 moved = *camera.project(front);
    EXPECT_GT(moved.x, 800);
    EXPECT_GT(moved.y, 450);
}

TEST(Camera, worldPerPixelIsTheStepBetweenPixelsAtThatDepth)
{
    const Camera camera = someCamera();
    const glm::dvec3 point(0.5, -0.3, 0.8);
    const glm::dvec3 right = glm::normalize(camera.pixelRay({0, 0}).perX);
    const glm::dvec2 a = *camera.project(point);
    const glm::dvec2 b = *camera.project(point + right * camera.worldPerPixel(point));
    expectNear(b, a + glm::dvec2(1, 0), 1e-9);
}

TEST(Camera, clipPlanesHoldTheSceneFromNearAndFar)
{
    for (const double distance : {0.01, 0.5, 4.0, 500.0}) {
        Camera camera = someCamera();
        camera.setPose({{0, 0, 0}, distance, 0.3, 0.2});
        const glm::dvec3 back = camera.pose().target + camera.forward() * 0.99;
        const glm::vec4 clip = camera.projection() * camera.view() * glm::vec4(glm::vec3(back), 1);
        EXPECT_LE(clip.z, clip.w);
        EXPECT_GE(clip.z, -clip.w);
    }
}

TEST(Camera, impossiblePosesAreBroughtIntoRangeOrIgnored)
{
    Camera camera = someCamera();
    const CameraPose before = camera.pose();
    camera.setPose({{0, std::numeric_limits<double>::quiet_NaN(), 0}, 1, 0, 0});
    EXPECT_EQ(camera.pose(), before);
    camera.zoom(0);
    EXPECT_GT(camera.pose().distance, 0);
    camera.zoom(1e300);
    EXPECT_LT(camera.pose().distance, 1e6);
    camera.setScene({0, 0, 0}, {0, 0, 0});
    camera.setViewport(0, -3);
    EXPECT_TRUE(std::isfinite(camera.projection()[0][0]));
    EXPECT_TRUE(std::isfinite(camera.pixelRay({0, 0}).direction.x));
}

TEST(Camera, leaningTurnsThePictureAboutItsMiddle)
{
    const Camera upright = someCamera();
    Camera leaning = upright;
    CameraPose pose = upright.pose();
    pose.roll = 0.5;
    leaning.setPose(pose);
    EXPECT_EQ(leaning.eye(), upright.eye());
    EXPECT_EQ(leaning.forward(), upright.forward());
    const glm::dvec3 point(0.5, -0.3, 0.8);
    const glm::dvec2 before = *upright.project(point) - glm::dvec2(800, 450);
    // The camera leans to the right: what it sees turns to the left.
    const glm::dvec2 turned(std::cos(0.5) * before.x + std::sin(0.5) * before.y,
                            std::cos(0.5) * before.y - std::sin(0.5) * before.x);
    expectNear(*leaning.project(point), glm::dvec2(800, 450) + turned, 1e-9);
    expectNear(*leaning.project(point), onScreen(leaning, point), 1e-2);
}

TEST(Camera, orbitFollowsThePointerWhateverTheRoll)
{
    for (const double roll : {0.0, 0.8, 2.5, -1.6}) {
        Camera camera = someCamera();
        camera.setPose({{0, 0, 0}, 4, 0.3, 0.0, roll});
        const glm::dvec3 front = -camera.forward(); // nearest to the camera
        const glm::dvec2 before = *camera.project(front);
        camera.orbit({3, 2});
        const glm::dvec2 moved = *camera.project(front) - before;
        EXPECT_NEAR(moved.y / moved.x, 2.0 / 3, 1e-3) << roll;
        EXPECT_GT(moved.x, 0) << roll;
    }
}

TEST(Camera, framingIsUprightWithTheUsualFieldOfView)
{
    Camera camera = someCamera();
    camera.setPose({{0, 0, 0}, 4, 0.3, 0.1, 1.0, 0.1});
    camera.frame({-1, -1, -1}, {1, 1, 1});
    EXPECT_EQ(camera.pose().roll, 0);
    EXPECT_EQ(camera.pose().fieldOfView, kFieldOfView);
    EXPECT_EQ(camera.pose().yaw, 0.3);
}

TEST(Camera, aTargetBeyondTheSceneCutsNothingClose)
{
    Camera camera = someCamera();
    camera.setPose({{0, 0, -100}, 100, 0, 0}); // the eye is in the middle of the scene
    const glm::vec4 clip = camera.projection() * camera.view() * glm::vec4(0, 0, -0.1F, 1);
    EXPECT_GE(clip.z, -clip.w);
}
