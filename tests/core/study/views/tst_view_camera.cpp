// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/views/view_camera.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <gmock/gmock.h>
#include <limits>
#include <numbers>
#include <random>

namespace trixel {
namespace {

using testing::HasSubstr;

ViewCamera tilted()
{
    return {"tilted", {2, 1, 4}, {0.3, -0.2, 0.1}, {0.1, 1, 0.2}, 40, 640, 360};
}

TEST(ViewCamera, looksAtItsTargetInTheMiddle)
{
    const ViewCamera camera = tilted();
    const auto middle = camera.project(camera.target);
    ASSERT_TRUE(middle);
    EXPECT_NEAR(middle->x, 320, 1e-9);
    EXPECT_NEAR(middle->y, 180, 1e-9);
}

TEST(ViewCamera, fieldOfViewSpansTheHeight)
{
    const ViewCamera camera = tilted();
    const glm::dvec3 top = glm::normalize(camera.pixelRay(320, 0).direction);
    const glm::dvec3 bottom = glm::normalize(camera.pixelRay(320, 360).direction);
    EXPECT_NEAR(std::acos(glm::dot(top, bottom)) * 180 / std::numbers::pi, 40, 1e-9);
    EXPECT_GT(glm::dot(top, camera.up), glm::dot(bottom, camera.up)) << "y goes down";
}

TEST(ViewCamera, raysAndProjectionAgree)
{
    const ViewCamera camera = tilted();
    std::mt19937 random(1);
    std::uniform_real_distribution<double> anywhere(-50, 700);
    for (int k = 0; k < 200; ++k) {
        const glm::dvec2 at(anywhere(random), anywhere(random));
        const PixelRay ray = camera.pixelRay(at.x, at.y);
        const auto back = camera.project(ray.origin + 3.7 * ray.direction);
        ASSERT_TRUE(back);
        EXPECT_NEAR(back->x, at.x, 1e-9);
        EXPECT_NEAR(back->y, at.y, 1e-9);
        EXPECT_EQ(camera.frames(ray.origin + ray.direction),
                  at.x >= 0 && at.y >= 0 && at.x <= 640 && at.y <= 360);
    }
    EXPECT_FALSE(camera.project(camera.position - camera.forward()));
    EXPECT_FALSE(camera.frames(camera.position - camera.forward(), 1e9));
}

/// No way to turn a small plate at the point brings neighbouring pixels closer together on it.
TEST(ViewCamera, noPlateIsSeenMoreFinelyThanUnitsPerPixel)
{
    const ViewCamera camera{"wide", {0, 0, 5}, {0, 0, 0}, {0, 1, 0}, 90, 200, 200};
    std::mt19937 random(2);
    std::normal_distribution<double> normal;
    double closest = std::numeric_limits<double>::infinity();
    for (int k = 0; k < 4000; ++k) {
        const PixelRay ray = camera.pixelRay(199.5, 100.0);
        const glm::dvec3 point = ray.origin + 2.0 * ray.direction;
        // A triangle about the point with random edges: most of them turned away.
        const glm::dvec3 toCamera = -glm::normalize(ray.direction);
        const double turn = k % 4 == 0 ? 0.02 : 1.0;
        const glm::dvec3 n = glm::normalize(
            toCamera + turn * glm::dvec3(normal(random), normal(random), normal(random)));
        if (glm::dot(n, toCamera) < 0.05) {
            continue;
        }
        const glm::dvec3 x = glm::normalize(glm::cross(n, glm::dvec3(0.3, 0.8, 0.5)));
        const glm::dvec3 y = glm::cross(n, x);
        const std::array<glm::vec3, 3> corners = {
            glm::vec3(point), glm::vec3(point + x), glm::vec3(point + y)};
        // Half axes of ¼ WWᵀ: half the spacing.
        const double spacing = 2 * ellipseOf(screenFootprint(ray, corners), corners).minorLength;
        const double bound = camera.unitsPerPixel(point);
        EXPECT_GE(spacing, bound * (1 - 1e-6));
        closest = std::min(closest, spacing / bound);
    }
    EXPECT_LT(closest, 1.001) << "the bound is reached";
}

TEST(DistantViews, areNeverCloserThanTheySay)
{
    DistantViews views{"far", 3, 50, 640, 360};
    std::mt19937 random(3);
    std::uniform_real_distribution<double> part(0, 1);
    double closest = std::numeric_limits<double>::infinity();
    for (int k = 0; k < 1000; ++k) {
        const ViewCamera camera{"", {0, 0, 0}, {0, 0, -1}, {0, 1, 0}, 50, 640, 360};
        const double x = k == 0 ? 0.0 : part(random) * 640;
        const double y = k == 0 ? 0.0 : part(random) * 360;
        const glm::dvec3 ray = glm::normalize(camera.pixelRay(x, y).direction);
        const double spacing = camera.unitsPerPixel(3.0 * ray);
        EXPECT_GE(spacing, views.unitsPerPixel() * (1 - 1e-12));
        closest = std::min(closest, spacing / views.unitsPerPixel());
    }
    EXPECT_NEAR(closest, 1, 1e-12);
}

TEST(SceneViews, finestSpacingComesFromTheCamerasThatFrameThePoint)
{
    const ViewCamera front{"front", {0, 0, 4}, {0, 0, 0}, {0, 1, 0}, 35, 400, 400};
    const ViewCamera near{"near", {0, 0, 1}, {0, 0, 0}, {0, 1, 0}, 35, 400, 400};
    SceneViews views{{front, near}, {}};
    EXPECT_EQ(views.finestSpacing({0, 0, 0}), near.unitsPerPixel({0, 0, 0}));
    // Beside the near picture, in the far one.
    EXPECT_EQ(views.finestSpacing({0.8, 0, 0}), front.unitsPerPixel({0.8, 0, 0}));
    EXPECT_EQ(views.finestSpacing({50, 0, 0}), std::numeric_limits<double>::infinity());
    EXPECT_EQ(views.finestSpacing({0, 0, 9}), std::numeric_limits<double>::infinity());

    views.distant.push_back({"far", 100, 35, 400, 400});
    EXPECT_EQ(views.finestSpacing({50, 0, 0}), views.distant[0].unitsPerPixel());
    EXPECT_EQ(views.finestSpacing({0, 0, 0}), near.unitsPerPixel({0, 0, 0}));
}

TEST(CamerasFile, readsBackWhatItWrites)
{
    SceneViews views;
    views.cameras = {tilted(), {"b \"q\"", {1e-3, 1e9, 3}, {0, 0, 0}, {0, 0, 1}, 179.5, 1, 32768}};
    views.distant = {{"any", 2.5, 60, 800, 600}};
    const auto back = parseCameras(writeCameras(views));
    ASSERT_TRUE(back) << back.error().message;
    EXPECT_EQ(*back, views);
}

TEST(CamerasFile, whatIsValidCanBeReadBack)
{
    ViewCamera far = tilted();
    far.position.x = kLargestCoordinate;
    ASSERT_TRUE(validate(far));
    EXPECT_EQ(parseCameras(writeCameras({{far}, {}})).value().cameras.front(), far);
    far.position.x = std::nextafter(kLargestCoordinate, 1e300);
    EXPECT_THAT(validate(far).error().message, HasSubstr("position, target and up"));
}

TEST(CamerasFile, whatIsLeftOutHasItsDefault)
{
    const auto views = parseCameras(
        R"({"version":1,"cameras":[{"position":[0,0,5],"target":[0,0,0]},{"anyBeyond":2}]})");
    ASSERT_TRUE(views) << views.error().message;
    EXPECT_EQ(views->cameras[0].name, "camera 1");
    EXPECT_EQ(views->cameras[0].up, glm::dvec3(0, 1, 0));
    EXPECT_EQ(views->cameras[0].fovY, 35);
    EXPECT_EQ(views->cameras[0].width, 1920);
    EXPECT_EQ(views->distant[0].name, "camera 2");
    EXPECT_EQ(views->distant[0].distance, 2);
}

TEST(CamerasFile, faultsAreNamedInOneSentence)
{
    const auto complaint = [](const std::string& cameras) {
        const auto views = parseCameras(R"({"version":1,"cameras":)" + cameras + "}");
        return views ? std::string("accepted") : views.error().message;
    };
    const std::string good = R"("position":[0,0,5],"target":[0,0,0])";
    EXPECT_THAT(complaint("[]"), HasSubstr("expected at least one camera"));
    EXPECT_THAT(complaint("{}"), HasSubstr("expected an array, found an object"));
    EXPECT_THAT(complaint("[3]"), HasSubstr("camera 1: expected an object, found 3"));
    EXPECT_THAT(complaint(R"([{"position":[0,0,5]}])"), HasSubstr("camera 1: target is missing"));
    EXPECT_THAT(complaint(R"([{"target":[0,0,5]}])"), HasSubstr("position is missing"));
    EXPECT_THAT(complaint(R"([{"position":[0,0],"target":[0,0,0]}])"),
                HasSubstr("position: expected an array of 3 finite numbers"));
    EXPECT_THAT(complaint(R"([{"position":[0,0,1e300],"target":[0,0,0]}])"),
                HasSubstr("position: expected an array of 3 finite numbers"));
    EXPECT_THAT(complaint(R"([{"position":[0,0,0],"target":[0,0,0]}])"),
                HasSubstr("target: expected another place"));
    EXPECT_THAT(complaint("[{" + good + R"(,"up":[0,0,2]}])"),
                HasSubstr("up: expected a direction across the view"));
    EXPECT_THAT(complaint("[{" + good + R"(,"fovY":180}])"), HasSubstr("fovY: expected degrees"));
    EXPECT_THAT(complaint("[{" + good + R"(,"fovY":"35"}])"),
                HasSubstr("fovY: expected a finite number"));
    EXPECT_THAT(complaint("[{" + good + R"(,"size":[0,5]}])"), HasSubstr("size: expected two"));
    EXPECT_THAT(complaint("[{" + good + R"(,"size":[10.5,5]}])"), HasSubstr("size: expected two"));
    EXPECT_THAT(complaint("[{" + good + R"(,"fov":35}])"), HasSubstr("there is no field \"fov\""));
    EXPECT_THAT(complaint("[{" + good + R"(,"name":7}])"), HasSubstr("name: expected a text"));
    EXPECT_THAT(complaint("[{" + good + R"(,"anyBeyond":2}])"),
                HasSubstr("there is no field \"position\""));
    EXPECT_THAT(complaint(R"([{"anyBeyond":0}])"), HasSubstr("anyBeyond: expected a distance"));
    EXPECT_THAT(complaint(R"([{"name":"hero","anyBeyond":-1}])"), HasSubstr("camera 'hero'"));

    EXPECT_THAT(parseCameras("{").error().message, HasSubstr("not JSON"));
    EXPECT_THAT(parseCameras(R"({"cameras":[]})").error().message, HasSubstr("version is missing"));
    EXPECT_THAT(parseCameras(R"({"version":2,"cameras":[]})").error().message,
                HasSubstr("version: expected 1, found 2"));
}

} // namespace
} // namespace trixel
