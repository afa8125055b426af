// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/camera_view.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <random>

using namespace trixel;
using namespace trixel::render;

namespace {

Camera cameraOf(int width, int height)
{
    Camera camera;
    camera.setViewport(width, height);
    camera.setScene({-1, -1, -1}, {1, 1, 1});
    return camera;
}

/// The largest difference of direction and origin between the rays of both at the same pixels.
double differenceOfRays(const Camera& camera, const ViewCamera& view)
{
    double most = 0;
    for (const glm::dvec2 part : {glm::dvec2(0, 0), {1, 0}, {0, 1}, {1, 1}, {0.3, 0.6}}) {
        const glm::dvec2 at = part * glm::dvec2(view.width, view.height);
        const PixelRay a = camera.pixelRay(at);
        const PixelRay b = view.pixelRay(at.x, at.y);
        most = std::max({most,
                         glm::length(a.origin - b.origin),
                         glm::length(a.direction - b.direction),
                         glm::length(a.perX - b.perX) * view.width,
                         glm::length(a.perY - b.perY) * view.height});
    }
    return most;
}

} // namespace

TEST(LookThrough, aViewTakenAndGoneBackToIsTheSamePicture)
{
    std::mt19937 random(3);
    std::uniform_real_distribution<double> angle(-std::numbers::pi, std::numbers::pi);
    for (const glm::ivec2 size :
         {glm::ivec2(1600, 900), glm::ivec2(301, 900), glm::ivec2(64, 64)}) {
        for (int k = 0; k < 50; ++k) {
            Camera camera = cameraOf(size.x, size.y);
            camera.setPose({{0.1, 0.2, -0.3}, 4, angle(random), angle(random) / 2, 0});
            const CameraPose before = camera.pose();
            const ViewCamera view = viewOf(camera);
            camera.frame({-1, -1, -1}, {0, 0, 0});
            lookThrough(camera, view);
            EXPECT_LT(differenceOfRays(camera, view), 1e-12);
            // Orbiting goes on about the same point.
            EXPECT_LT(glm::length(camera.pose().target - before.target), 1e-12);
            EXPECT_NEAR(camera.pose().distance, before.distance, 1e-12);
            EXPECT_NEAR(camera.pose().fieldOfView, before.fieldOfView, 1e-12);
            EXPECT_NEAR(camera.pose().roll, 0, 1e-9);
        }
    }
}

TEST(LookThrough, anyCameraOfAFileIsSeenThroughAsItIs)
{
    std::mt19937 random(7);
    std::uniform_real_distribution<double> anywhere(-3, 3);
    const auto place = [&] {
        return glm::dvec3(anywhere(random), anywhere(random), anywhere(random));
    };
    for (int k = 0; k < 300; ++k) {
        ViewCamera view{"", place(), place(), place(), 35 + 11 * anywhere(random), 640, 360};
        ASSERT_TRUE(validate(view));
        Camera camera = cameraOf(view.width, view.height);
        lookThrough(camera, view);
        EXPECT_LT(differenceOfRays(camera, view), 1e-9) << k;
        EXPECT_LT(differenceOfRays(camera, viewOf(camera)), 1e-9) << k;
    }
}

TEST(LookThrough, straightDownAndUpAreNoSpecialCase)
{
    for (const double side : {-1.0, 1.0}) {
        for (const glm::dvec3 up : {glm::dvec3(0, 0, 1), {1, 0, 0}, {-0.3, 0, -0.7}}) {
            const ViewCamera view{"", {0, 3 * side, 0}, {0, 0, 0}, up, 35, 640, 360};
            Camera camera = cameraOf(view.width, view.height);
            lookThrough(camera, view);
            EXPECT_LT(differenceOfRays(camera, view), 1e-9);
            EXPECT_NEAR(camera.pose().roll, 0, 1e-9) << "orbiting starts upright";
        }
    }
}

TEST(LookThrough, aViewportOfAnotherShapeShowsTheWholePicture)
{
    const ViewCamera view{"", {0.5, 1, 3}, {0, 0, 0}, {0, 1, 0}, 30, 640, 360};
    for (const glm::ivec2 size :
         {glm::ivec2(1280, 720), glm::ivec2(640, 900), glm::ivec2(2000, 300)}) {
        Camera camera = cameraOf(size.x, size.y);
        lookThrough(camera, view);
        const double scale = std::min(size.x / 640.0, size.y / 360.0);
        const glm::dvec2 middle = glm::dvec2(size) / 2.0;
        for (const glm::dvec2 corner : {glm::dvec2(0, 0), {640, 0}, {0, 360}, {640, 360}}) {
            const PixelRay ray = view.pixelRay(corner.x, corner.y);
            const glm::dvec2 at = *camera.project(ray.origin + ray.direction);
            EXPECT_LT(glm::length(at - (middle + scale * (corner - glm::dvec2(320, 180)))), 1e-9);
        }
    }
}

TEST(LookThrough, aTargetOutOfRangeGivesWayNotThePosition)
{
    for (const double distance : {1e-9, 1e9}) {
        const ViewCamera view{"", {0, 0, 3}, {0, 0, 3 - distance}, {0, 1, 0}, 35, 640, 360};
        Camera camera = cameraOf(640, 360);
        lookThrough(camera, view);
        EXPECT_LT(differenceOfRays(camera, view), 1e-9) << distance;
    }
}
