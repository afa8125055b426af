// SPDX-License-Identifier: GPL-3.0-or-later
//
// How large an error on a surface looks.
#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>

namespace trixel {

/// What a face is inside of: a ball, and two planes on either side of it.
struct FaceBounds
{
    glm::vec3 centre{0};
    float radius = 0;
    glm::vec3 normal{0}; ///< of the planes, of unit length; zero: no planes
    float height = 0;    ///< from the centre to either plane
};

/// A perspective view of a picture.
struct PictureView
{
    glm::dmat4 toCamera{1};     ///< world → camera, rigid; the camera looks along -z
    double focalLength = 1;     ///< pixels
    glm::dvec2 halfSize{1};     ///< of the picture, pixels
    double nearestDepth = 1e-6; ///< of what is seen, > 0
};

/// How many units of error a length of the world may look like: pixels where it is a picture's.
class ErrorScale
{
public:
    /// Lengths are what they are, and all is in view.
    static ErrorScale ofWorld() { return ErrorScale(std::nullopt); }
    /// Pixels of a picture and a margin of a tenth around it.
    static ErrorScale ofPicture(const PictureView& view) { return ErrorScale(view); }

    /// At most so many units for a unit of length anywhere on the face; 0 when it is out of view.
    double at(const FaceBounds& face) const;

private:
    explicit ErrorScale(const std::optional<PictureView>& view);

    std::optional<PictureView> m_view;
    glm::dvec3 m_eye{0};
    glm::dvec2 m_reach{0};  ///< half the picture with its margin
    glm::dvec2 m_planes{0}; ///< lengths of the side planes' normals
    double m_corner = 1;    ///< distance of a corner of the picture from the eye, pixels
};

} // namespace trixel
