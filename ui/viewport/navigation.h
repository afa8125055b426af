// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Qt>

#include "render/camera.h"

#include <optional>

namespace trixel::ui {

/// Ways of moving the camera by dragging.
enum class CameraDrag { Orbit, Pan, Zoom };

/// Which a button starts with the keys held, if any.
std::optional<CameraDrag> cameraDragFor(Qt::MouseButton button, Qt::KeyboardModifiers modifiers);

/// Moves the camera by a drag of so many device pixels.
/// \param start  where the drag began: zooming goes towards it
void dragCamera(render::Camera& camera, CameraDrag drag, glm::dvec2 pixels, glm::dvec2 start);

/// Zooms by a turn of the wheel. \param steps  notches, away from the user is positive
void wheelCamera(render::Camera& camera, double steps, glm::dvec2 position);

} // namespace trixel::ui
