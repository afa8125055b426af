// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/camera_view.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

namespace trixel::render {

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
    view.fovY = 2 * std::atan(middle.y * glm::length(ray.perY)) * 180 / std::numbers::pi;
    return view;
}

} // namespace trixel::render
