// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/views/view_camera.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <numbers>

namespace trixel {
namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();

/// Length of a pixel in the plane at distance 1.
double pixelLength(double fovY, int height)
{
    return 2 * std::tan(fovY * std::numbers::pi / 360) / height;
}

bool isUsable(const glm::dvec3& v)
{
    const auto usable = [](double x) { return std::abs(x) <= kLargestCoordinate; };
    return usable(v.x) && usable(v.y) && usable(v.z);
}

struct Frame
{
    glm::dvec3 forward, right, down;

    explicit Frame(const ViewCamera& camera)
        : forward(camera.forward())
        , right(glm::normalize(glm::cross(forward, camera.up)))
        , down(glm::cross(forward, right))
    {
    }
};

Status checkPicture(const std::string& place, double fovY, int width, int height)
{
    if (!(fovY > 0 && fovY < 180)) {
        return contentsError(place + ": fovY: expected degrees above 0 and below 180, found " +
                             std::to_string(fovY));
    }
    if (std::min(width, height) < 1 || std::max(width, height) > kMostPixels) {
        return contentsError(place + ": size: expected two sides of 1 to " +
                             std::to_string(kMostPixels) + " pixels, found " +
                             std::to_string(width) + " × " + std::to_string(height));
    }
    return {};
}

} // namespace

glm::dvec3 ViewCamera::forward() const
{
    return glm::normalize(target - position);
}

PixelRay ViewCamera::pixelRay(double x, double y) const
{
    const Frame frame(*this);
    const double length = pixelLength(fovY, height);
    PixelRay ray;
    ray.origin = position;
    ray.perX = length * frame.right;
    ray.perY = length * frame.down;
    ray.direction = frame.forward + (x - width / 2.0) * ray.perX + (y - height / 2.0) * ray.perY;
    return ray;
}

std::optional<glm::dvec2> ViewCamera::project(glm::dvec3 point) const
{
    const Frame frame(*this);
    const glm::dvec3 offset = point - position;
    const double depth = glm::dot(offset, frame.forward);
    if (!(depth > 0)) {
        return std::nullopt;
    }
    const double scale = 1 / (depth * pixelLength(fovY, height));
    return glm::dvec2(width / 2.0 + scale * glm::dot(offset, frame.right),
                      height / 2.0 + scale * glm::dot(offset, frame.down));
}

bool ViewCamera::frames(glm::dvec3 point, double margin) const
{
    const auto at = project(point);
    return at && at->x >= -margin && at->y >= -margin && at->x <= width + margin &&
           at->y <= height + margin;
}

// At distance d, an angle θ off the axis, a plate across the ray has pixels d cosθ p apart along
// the circle about the axis and d cos²θ p apart towards it; with d cosθ = depth.
double ViewCamera::unitsPerPixel(glm::dvec3 point) const
{
    const glm::dvec3 offset = point - position;
    const double depth = glm::dot(offset, forward());
    return depth > 0 ? pixelLength(fovY, height) * depth * depth / glm::length(offset) : kNever;
}

double ViewCamera::unitsPerPixelTurned(glm::dvec3 point) const
{
    return pixelLength(fovY, height) * glm::length(point - position);
}

double DistantViews::unitsPerPixel() const
{
    // The corner of the picture is farthest off the axis.
    const double p = pixelLength(fovY, height);
    const glm::dvec2 corner(p * width / 2, p * height / 2);
    return p * distance / (1 + glm::dot(corner, corner));
}

double SceneViews::finestSpacing(glm::dvec3 point, double margin) const
{
    double finest = kNever;
    for (const ViewCamera& camera : cameras) {
        if (camera.frames(point, margin)) {
            finest = std::min(finest, camera.unitsPerPixel(point));
        }
    }
    for (const DistantViews& views : distant) {
        finest = std::min(finest, views.unitsPerPixel());
    }
    return finest;
}

Status validate(const ViewCamera& camera)
{
    const std::string place = "camera '" + camera.name + "'";
    if (!isUsable(camera.position) || !isUsable(camera.target) || !isUsable(camera.up)) {
        return contentsError(place +
                             ": position, target and up: expected finite numbers, none above 1e18");
    }
    const glm::dvec3 view = camera.target - camera.position;
    if (!(glm::length(view) > 0) || !std::isfinite(glm::length(view))) {
        return contentsError(place + ": target: expected another place than the position");
    }
    constexpr double kParallel = 1e-9; // sine of the angle
    const double across = glm::length(glm::cross(glm::normalize(view), camera.up));
    if (!(across > kParallel * glm::length(camera.up)) || !std::isfinite(across)) {
        return contentsError(place + ": up: expected a direction across the view");
    }
    return checkPicture(place, camera.fovY, camera.width, camera.height);
}

Status validate(const DistantViews& views)
{
    const std::string place = "camera '" + views.name + "'";
    if (!(views.distance > 0) || !std::isfinite(views.distance)) {
        return contentsError(place + ": anyBeyond: expected a distance above 0, found " +
                             std::to_string(views.distance));
    }
    return checkPicture(place, views.fovY, views.width, views.height);
}

} // namespace trixel
