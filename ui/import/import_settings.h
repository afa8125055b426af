// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/image/color_space.h"
#include "core/image/image_sampler.h"
#include "core/mapping/quad.h"
#include "core/study/views/view_camera.h"

#include <array>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>

namespace trixel::ui {

/// How an image is laid onto the surface.
enum class MapKind { Uvs, Sphere, Plane, Quad, Camera };

/// The direction that a plane's image is looked at along, and that its upper edge lies towards.
enum class PlaneSide { Front, Back, Right, Left, Top, Bottom };

struct SphereSettings
{
    glm::dvec3 centre{0};
    glm::dvec3 axis{0, 1, 0}; ///< from the lower pole to the upper
    double turn = 0;          ///< degrees about the axis

    bool operator==(const SphereSettings&) const = default;
};

struct PlaneSettings
{
    glm::dvec3 centre{0}; ///< of the image
    PlaneSide side = PlaneSide::Front;
    double turn = 0;       ///< degrees, counter-clockwise as the image is seen
    glm::dvec2 size{1, 1}; ///< of the image in the world, > 0

    bool operator==(const PlaneSettings&) const = default;
};

/// Four corners in the picture of a camera that stays where it is when the view moves on.
struct CameraSettings
{
    ViewCamera camera;
    Quad corners{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}; ///< clip space, y upwards

    bool operator==(const CameraSettings& other) const
    {
        const auto same = [](const Quad& a, const Quad& b) {
            return a.p00 == b.p00 && a.p10 == b.p10 && a.p11 == b.p11 && a.p01 == b.p01;
        };
        return camera == other.camera && same(corners, other.corners);
    }
};

/// All that says how an image becomes texels, but for the image and the faces. A value.
struct ImportSettings
{
    MapKind kind = MapKind::Camera;
    SphereSettings sphere;
    PlaneSettings plane;
    std::array<glm::dvec3, 4> quad{}; ///< (s,t) = (0,0), (1,0), (1,1), (0,1) in the world
    CameraSettings camera;
    bool frontOnly = true;   ///< for Plane, Quad and Camera
    bool visibleOnly = true; ///< the same
    bool repeats = false;    ///< the image goes on beyond its borders; for Uvs

    ImageLookup lookup = ImageLookup::Footprint;
    TableIndex index = TableIndex::Centres;
    std::optional<ColorSpace> color;      ///< of the image's colours; nothing: as its file says
    std::optional<std::uint16_t> channel; ///< of the image, for all colours; nothing: each its own
    double opacity = 1;                   ///< [0,1]

    bool operator==(const ImportSettings&) const = default;

    bool isProjection() const
    {
        return kind == MapKind::Plane || kind == MapKind::Quad || kind == MapKind::Camera;
    }
};

} // namespace trixel::ui
