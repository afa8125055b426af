// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/viewport/navigation.h"

#include <algorithm>
#include <cmath>

namespace trixel::ui {

namespace {

constexpr double kZoomPerPictureDragged = 4.0; // e-folds for a drag over the shorter side
constexpr double kZoomPerNotch = 0.15;         // e-folds
constexpr double kMostNotches = 20;            // in one event

} // namespace

std::optional<CameraDrag> cameraDragFor(Qt::MouseButton button, Qt::KeyboardModifiers modifiers)
{
    const bool alt = modifiers.testFlag(Qt::AltModifier);
    const bool shift = modifiers.testFlag(Qt::ShiftModifier);
    switch (button) {
    case Qt::LeftButton:
        return alt ? std::optional(CameraDrag::Orbit) : std::nullopt;
    case Qt::MiddleButton:
        return alt || shift ? CameraDrag::Pan : CameraDrag::Orbit;
    case Qt::RightButton:
        return alt ? std::optional(CameraDrag::Zoom) : std::nullopt;
    default:
        return std::nullopt;
    }
}

void dragCamera(render::Camera& camera, CameraDrag drag, glm::dvec2 pixels, glm::dvec2 start)
{
    switch (drag) {
    case CameraDrag::Orbit:
        camera.orbit(pixels);
        break;
    case CameraDrag::Pan:
        camera.pan(pixels);
        break;
    case CameraDrag::Zoom: {
        const double side = std::min(camera.viewport().x, camera.viewport().y);
        const double nearer = kZoomPerPictureDragged * (pixels.x - pixels.y) / side;
        camera.zoomTowards(std::exp(-nearer), start);
        break;
    }
    }
}

void wheelCamera(render::Camera& camera, double steps, glm::dvec2 position)
{
    const double notches = std::clamp(steps, -kMostNotches, kMostNotches);
    camera.zoomTowards(std::exp(-kZoomPerNotch * notches), position);
}

} // namespace trixel::ui
