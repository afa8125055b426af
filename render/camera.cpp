// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/camera.h"

#include <algorithm>
#include <cmath>
#include <glm/ext/matrix_clip_space.hpp>
#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>
#include <numbers>

namespace trixel::render {

namespace {

constexpr double kSteepest = std::numbers::pi / 2;
constexpr double kSteepestOrbit = kSteepest - 1e-4; // short of the pole, where yaw means roll
constexpr double kNarrowest = 1e-4;
constexpr double kWidest = std::numbers::pi - 1e-2;
constexpr double kFrameMargin = 0.9; // part of the picture that a framed box fills
/// Distances allowed, in radii of the scene.
constexpr double kNearest = 1e-5;
constexpr double kFarthest = 1e3;

bool isFinite(const CameraPose& pose)
{
    return std::isfinite(pose.target.x) && std::isfinite(pose.target.y) &&
           std::isfinite(pose.target.z) && std::isfinite(pose.distance) &&
           std::isfinite(pose.yaw) && std::isfinite(pose.pitch) && std::isfinite(pose.roll) &&
           std::isfinite(pose.fieldOfView);
}

} // namespace

void Camera::setViewport(int width, int height)
{
    m_viewport = {std::max(width, 1), std::max(height, 1)};
}

void Camera::setScene(glm::vec3 low, glm::vec3 high)
{
    m_sceneCentre = (glm::dvec3(low) + glm::dvec3(high)) / 2.0;
    const double radius = glm::length(glm::dvec3(high) - glm::dvec3(low)) / 2;
    m_sceneRadius = radius > 0 && std::isfinite(radius) ? radius : 1;
    setPose(m_pose);
}

void Camera::setPose(const CameraPose& pose)
{
    if (!isFinite(pose)) {
        return;
    }
    m_pose = pose;
    m_pose.distance =
        std::clamp(pose.distance, kNearest * m_sceneRadius, kFarthest * m_sceneRadius);
    m_pose.pitch = std::clamp(pose.pitch, -kSteepest, kSteepest);
    m_pose.yaw = std::remainder(pose.yaw, 2 * std::numbers::pi);
    m_pose.roll = std::remainder(pose.roll, 2 * std::numbers::pi);
    m_pose.fieldOfView = std::clamp(pose.fieldOfView, kNarrowest, kWidest);
}

glm::dvec3 Camera::forward() const
{
    const double level = std::cos(m_pose.pitch);
    return {-std::sin(m_pose.yaw) * level, -std::sin(m_pose.pitch), -std::cos(m_pose.yaw) * level};
}

glm::dvec3 Camera::right() const
{
    const glm::dvec3 level(std::cos(m_pose.yaw), 0, -std::sin(m_pose.yaw));
    const glm::dvec3 upright = glm::cross(level, forward());
    return std::cos(m_pose.roll) * level - std::sin(m_pose.roll) * upright;
}

glm::dvec3 Camera::up() const
{
    return glm::cross(right(), forward());
}

glm::dvec3 Camera::eye() const
{
    return m_pose.target - m_pose.distance * forward();
}

double Camera::pixelsPerUnit() const
{
    return std::min(m_viewport.x, m_viewport.y) / (2 * std::tan(m_pose.fieldOfView / 2));
}

glm::mat4 Camera::view() const
{
    return glm::mat4(glm::lookAt(eye(), m_pose.target, up()));
}

Camera::Depths Camera::depths() const
{
    // Tight planes keep depth precision: overlays lie on the surface by a small bias.
    const double toCentre = glm::dot(m_sceneCentre - eye(), forward());
    const double reach = 1.01 * m_sceneRadius;
    const double far = std::max(toCentre + reach, m_pose.distance * 1.01);
    // A target beyond the scene, as a given view may have, is no reason to cut what is close.
    const double closest = 0.01 * std::min({m_pose.distance, far, reach});
    return {std::max(toCentre - reach, closest), far};
}

glm::mat4 Camera::projection() const
{
    const auto [near, far] = depths();
    const double x = m_viewport.x / (2 * pixelsPerUnit()) * near;
    const double y = m_viewport.y / (2 * pixelsPerUnit()) * near;
    return glm::mat4(glm::frustum(-x, x, -y, y, near, far));
}

PixelRay Camera::pixelRay(glm::dvec2 position) const
{
    const double step = 1 / pixelsPerUnit();
    PixelRay ray;
    ray.origin = eye();
    ray.perX = step * right();
    ray.perY = -step * up();
    ray.direction = forward() + (position.x - m_viewport.x / 2.0) * ray.perX +
                    (position.y - m_viewport.y / 2.0) * ray.perY;
    return ray;
}

std::optional<glm::dvec2> Camera::project(glm::dvec3 point) const
{
    const glm::dvec3 offset = point - eye();
    const double depth = glm::dot(offset, forward());
    if (!(depth > 0)) {
        return std::nullopt;
    }
    const double scale = pixelsPerUnit() / depth;
    return glm::dvec2(m_viewport.x / 2.0 + scale * glm::dot(offset, right()),
                      m_viewport.y / 2.0 - scale * glm::dot(offset, up()));
}

double Camera::worldPerPixel(glm::dvec3 point) const
{
    return std::max(glm::dot(point - eye(), forward()), 0.0) / pixelsPerUnit();
}

void Camera::orbit(glm::dvec2 pixels)
{
    // A drag over the shorter side is half a turn.
    const double perPixel = std::numbers::pi / std::min(m_viewport.x, m_viewport.y);
    CameraPose pose = m_pose;
    const double c = std::cos(pose.roll);
    const double s = std::sin(pose.roll);
    const glm::dvec2 level(c * pixels.x - s * pixels.y, s * pixels.x + c * pixels.y);
    pose.yaw -= level.x * perPixel;
    pose.pitch = std::clamp(pose.pitch + level.y * perPixel, -kSteepestOrbit, kSteepestOrbit);
    setPose(pose);
}

void Camera::pan(glm::dvec2 pixels)
{
    const double step = m_pose.distance / pixelsPerUnit();
    CameraPose pose = m_pose;
    pose.target += step * (-pixels.x * right() + pixels.y * up());
    setPose(pose);
}

void Camera::zoom(double factor)
{
    CameraPose pose = m_pose;
    pose.distance *= factor;
    setPose(pose);
}

void Camera::zoomTowards(double factor, glm::dvec2 position)
{
    const double before = m_pose.distance;
    zoom(factor);
    // In the plane of the target, what was under the position moves by what the distance lost.
    const glm::dvec2 fromMiddle = position - glm::dvec2(m_viewport) / 2.0;
    const double step = (before - m_pose.distance) / pixelsPerUnit();
    CameraPose pose = m_pose;
    pose.target += step * (fromMiddle.x * right() - fromMiddle.y * up());
    setPose(pose);
}

void Camera::frame(glm::vec3 low, glm::vec3 high)
{
    CameraPose pose = m_pose;
    pose.roll = 0;
    pose.fieldOfView = kFieldOfView;
    setPose(pose);
    const glm::dvec3 half = (glm::dvec3(high) - glm::dvec3(low)) / 2.0;
    const glm::dvec2 reach = kFrameMargin * glm::dvec2(m_viewport) / (2 * pixelsPerUnit());
    double distance = 0;
    for (int k = 0; k < 8; ++k) {
        const glm::dvec3 corner(
            k & 1 ? half.x : -half.x, k & 2 ? half.y : -half.y, k & 4 ? half.z : -half.z);
        // The corner is inside the picture when |offset| <= reach × its depth.
        const double depth = glm::dot(corner, forward());
        distance = std::max({distance,
                             std::abs(glm::dot(corner, right())) / reach.x - depth,
                             std::abs(glm::dot(corner, up())) / reach.y - depth});
    }
    pose.target = (glm::dvec3(low) + glm::dvec3(high)) / 2.0;
    pose.distance = distance > 0 ? distance : 0.1 * m_sceneRadius;
    setPose(pose);
}

} // namespace trixel::render
