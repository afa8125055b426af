// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/camera_view.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

namespace trixel::render {

namespace {

constexpr double kHalfTurn = 180;
constexpr double kVertical = 1e-9; // sine of the angle to the pole where yaw says nothing

/// The angles of a camera that looks along `forward` with `up` upwards in its picture.
CameraPose anglesOf(const glm::dvec3& forward, const glm::dvec3& up)
{
    const glm::dvec3 right = glm::normalize(glm::cross(forward, up));
    const double level = std::hypot(forward.x, forward.z);
    CameraPose pose;
    pose.yaw =
        level > kVertical ? std::atan2(-forward.x, -forward.z) : std::atan2(-right.z, right.x);
    pose.pitch = std::atan2(-forward.y, level);
    const glm::dvec3 across(std::cos(pose.yaw), 0, -std::sin(pose.yaw)); // right without roll
    pose.roll = std::atan2(glm::dot(glm::cross(across, right), forward), glm::dot(across, right));
    return pose;
}

/// Radians over the shorter side of a viewport in which the view's picture just fits.
double fieldOfViewOf(const ViewCamera& view, glm::dvec2 viewport)
{
    const double across = 2 * std::tan(view.fovY * std::numbers::pi / (2 * kHalfTurn)); // height
    const double scale = std::min(viewport.x / view.width, viewport.y / view.height);
    const double shorter = std::min(viewport.x, viewport.y);
    return 2 * std::atan(across * shorter / (2 * scale * view.height));
}

} // namespace

ViewCamera viewOf(const Camera& camera)
{
    const glm::dvec2 middle = glm::dvec2(camera.viewport()) / 2.0;
    const PixelRay ray = camera.pixelRay(middle);
    ViewCamera view;
    view.position = ray.origin;
    view.target = ray.origin + camera.pose().distance * ray.direction;
    view.up = glm::normalize(-ray.perY);
    view.width = camera.viewport().x;
    view.height = camera.viewport().y;
    view.fovY = 2 * std::atan(middle.y * glm::length(ray.perY)) * kHalfTurn / std::numbers::pi;
    return view;
}

void lookThrough(Camera& camera, const ViewCamera& view)
{
    const glm::dvec3 forward = view.forward();
    CameraPose pose = anglesOf(forward, view.up);
    pose.target = view.target;
    pose.distance = glm::length(view.target - view.position);
    pose.fieldOfView = fieldOfViewOf(view, camera.viewport());
    camera.setPose(pose);
    if (camera.pose().distance != pose.distance) {
        // Out of range: the target gives way, not the position.
        pose.distance = camera.pose().distance;
        pose.target = view.position + pose.distance * forward;
        camera.setPose(pose);
    }
}

} // namespace trixel::render
