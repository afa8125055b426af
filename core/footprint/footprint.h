// SPDX-License-Identifier: GPL-3.0-or-later
//
// The area of a texture that one screen pixel averages: two vectors in the (u,v) of a face, and
// the ellipse they stand for.
#pragma once

#include <array>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace trixel {

/// Sampling interval along two axes, in (u,v) of one face.
struct Footprint
{
    glm::dvec2 w1{0};
    glm::dvec2 w2{0};
};

/// Ellipse of a footprint in a metric plane: half axes of one standard deviation.
struct FootprintEllipse
{
    glm::dvec2 major{0};    ///< half axis as a vector in (u,v)
    glm::dvec2 minor{0};    ///< half axis as a vector in (u,v)
    double majorLength = 0; ///< length in the metric
    double minorLength = 0; ///< length in the metric; <= majorLength
    double anisotropy() const { return minorLength > 0 ? majorLength / minorLength : 1.0; }
};

/// A pinhole view: origin and the change of ray direction from one pixel to the next.
struct PixelRay
{
    glm::dvec3 origin{0};
    glm::dvec3 direction{0, 0, -1}; ///< through the pixel's centre
    glm::dvec3 perX{0};             ///< change of `direction` for one pixel to the right
    glm::dvec3 perY{0};             ///< change of `direction` for one pixel down
};

/// Footprint of a pixel on the plane of a face, from the analytic derivative of the ray's hit
/// point. Lengths are limited to `maxLength` (in uv) where the view is grazing, so that the result
/// is finite for every input; a degenerate face gives a zero footprint.
Footprint screenFootprint(const PixelRay& ray,
                          const std::array<glm::vec3, 3>& corners,
                          double maxLength = 64.0);

/// Ellipse with covariance ¼ (W1 W1ᵀ + W2 W2ᵀ) in the metric of the face's own shape.
/// \param corners  world positions of V0, V1, V2; lengths are in world units
FootprintEllipse ellipseOf(const Footprint& footprint, const std::array<glm::vec3, 3>& corners);

} // namespace trixel
