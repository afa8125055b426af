// SPDX-License-Identifier: GPL-3.0-or-later
//
// Views of a scene, as the cameras file lists them, and what they cover.
#pragma once

#include "core/base/result.h"
#include "core/footprint/footprint.h"

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace trixel {

/// Most pixels along a side of a picture.
inline constexpr int kMostPixels = 32768;
/// Largest coordinate of a camera: squares of it are far from overflow.
inline constexpr double kLargestCoordinate = 1e18;

/// A pinhole view with square pixels. Positions in the picture are in pixels from its top left
/// corner, y downwards: (0.5, 0.5) is the centre of the first.
struct ViewCamera
{
    std::string name;
    glm::dvec3 position{0, 0, 3};
    glm::dvec3 target{0};
    glm::dvec3 up{0, 1, 0};
    double fovY = 35; ///< degrees, over the height of the picture
    int width = 1920;
    int height = 1080;

    bool operator==(const ViewCamera&) const = default;

    /// Unit vector of the view direction.
    glm::dvec3 forward() const;
    PixelRay pixelRay(double x, double y) const;
    /// Where a point appears; nothing where it lies behind the camera.
    std::optional<glm::dvec2> project(glm::dvec3 point) const;
    /// Whether a point appears in the picture or at most `margin` pixels outside it. What stands
    /// in between is not asked.
    bool frames(glm::dvec3 point, double margin = 0) const;
    /// World units from pixel to pixel on a small plate that faces the camera at the point, in the
    /// direction in which they are fewest: no surface there is seen more finely. Infinite behind
    /// the camera.
    double unitsPerPixel(glm::dvec3 point) const;
    /// The same, if the camera turned from where it stands to look straight at the point.
    double unitsPerPixelTurned(glm::dvec3 point) const;
};

/// Every view whose position is at least `distance` from every point of the surface, with a picture
/// like this.
struct DistantViews
{
    std::string name;
    double distance = 1; ///< world units
    double fovY = 35;    ///< degrees
    int width = 1920;
    int height = 1080;

    bool operator==(const DistantViews&) const = default;

    /// The fewest units per pixel that such a view can have at a point of the surface.
    double unitsPerPixel() const;
};

/// What a scene is looked at with.
struct SceneViews
{
    std::vector<ViewCamera> cameras;
    std::vector<DistantViews> distant;

    bool operator==(const SceneViews&) const = default;

    bool isEmpty() const { return cameras.empty() && distant.empty(); }

    /// The fewest world units per pixel at a point over all the views that frame it: no covered
    /// view sees it closer. Infinite where none does.
    /// \param margin  pixels outside a picture that still count as framed
    double finestSpacing(glm::dvec3 point, double margin = 0) const;
};

/// Fails with a sentence, "camera 'hero': …", unless all numbers are finite, no coordinate is
/// larger than `kLargestCoordinate`, the position is not the target, `up` is not along the view, 0
/// < fovY < 180 and both sides are in [1, kMostPixels].
Status validate(const ViewCamera& camera);
Status validate(const DistantViews& views);

/// Reads a cameras file: {"version":1,"cameras":[{"name":"hero","position":[x,y,z],
/// "target":[x,y,z],"up":[0,1,0],"fovY":35,"size":[1920,1080]}, …]}, where "anyBeyond": D may stand
/// in place of position, target and up. Required are "version", "cameras" (at least one), and of
/// each camera position and target, or anyBeyond; what else is left out has its default, the name
/// its number. Errors name the camera and the field; fields of other names are refused.
Result<SceneViews> parseCameras(std::string_view json);

/// The text that `parseCameras` reads back to equal views (those of a distance after the others).
std::string writeCameras(const SceneViews& views);

} // namespace trixel
