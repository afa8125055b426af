// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/footprint/footprint.h"

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <numbers>
#include <optional>

namespace trixel::render {

/// The field of view of a camera that was not given another, radians.
inline constexpr double kFieldOfView = 35.0 * std::numbers::pi / 180;

/// Where an orbit camera stands: it looks at `target` from `distance`; angles in radians, y is up.
struct CameraPose
{
    glm::dvec3 target{0};
    double distance = 3;               ///< > 0
    double yaw = 0;                    ///< about y; 0 looks along -z
    double pitch = 0;                  ///< > 0 looks down; within ±90°
    double roll = 0;                   ///< > 0 leans the camera to the right
    double fieldOfView = kFieldOfView; ///< over the shorter side of the picture

    bool operator==(const CameraPose&) const = default;
};

/// Orbit camera with a perspective view. Positions on the screen are in device pixels, y downwards,
/// with (0.5, 0.5) the centre of the first pixel.
class Camera
{
public:
    /// Size of the picture in device pixels; nothing smaller than 1×1 is taken.
    void setViewport(int width, int height);
    glm::ivec2 viewport() const { return m_viewport; }

    /// Bounding box of what is shown; sets the clip planes and how near and far the camera may go.
    void setScene(glm::vec3 low, glm::vec3 high);

    const CameraPose& pose() const { return m_pose; }
    /// Values out of range are brought into it; a pose that is not finite is ignored.
    void setPose(const CameraPose& pose);

    glm::dvec3 eye() const;
    /// Unit vector of the view direction.
    glm::dvec3 forward() const;
    glm::mat4 view() const;
    glm::mat4 projection() const;

    /// The ray through a position on the screen.
    PixelRay pixelRay(glm::dvec2 position) const;
    /// Where a point appears; nothing when it lies behind the camera.
    std::optional<glm::dvec2> project(glm::dvec3 point) const;
    /// World length of one device pixel at the depth of a point.
    double worldPerPixel(glm::dvec3 point) const;
    /// The same at the depth at which drawing begins: nothing is drawn larger.
    double nearestWorldPerPixel() const { return depths().near / pixelsPerUnit(); }

    /// Turns about the target, as if the surface were dragged by so many pixels.
    void orbit(glm::dvec2 pixels);
    /// Moves sideways so that the target follows the pointer.
    void pan(glm::dvec2 pixels);
    /// Changes the distance by a factor (< 1 is nearer).
    void zoom(double factor);
    /// The same, keeping what is seen at a position in place.
    void zoomTowards(double factor, glm::dvec2 position);
    /// Shows a box whole, from the direction looked from now, upright and with the usual field of
    /// view. A point gets a sensible distance.
    void frame(glm::vec3 low, glm::vec3 high);

private:
    glm::dvec3 right() const;
    glm::dvec3 up() const;
    /// From the first that is drawn to the last.
    struct Depths
    {
        double near = 0;
        double far = 0;
    };
    Depths depths() const;
    double pixelsPerUnit() const; ///< device pixels of a length of 1 at distance 1

    CameraPose m_pose;
    glm::ivec2 m_viewport{1, 1};
    glm::dvec3 m_sceneCentre{0};
    double m_sceneRadius = 1;
};

} // namespace trixel::render
