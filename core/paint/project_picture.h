// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/parallel.h"
#include "core/mesh/triangle_mesh.h"
#include "core/texture/texel_patch.h"
#include "core/texture/texel_store.h"

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <span>

namespace trixel {

/// A picture in the hand of a camera, to be thrown onto a surface.
struct PictureProjection
{
    /// From the world to the clip space of the camera, whose picture fills it from -1 to 1 both
    /// ways; what has w <= 0 lies behind it.
    glm::dmat4 toClip{1};
    int width = 0; ///< pixels
    int height = 0;
    /// R G B A a pixel, rows from the top; the colour is not multiplied by the opacity.
    std::span<const float> pixels;
    float opacity = 1; ///< [0,1] of all of it
};

/// What lands on a point: a colour, and in the last how far it covers, 0 beside the picture.
/// Between the centres of pixels both are interpolated, colours by their opacity.
glm::vec4 projectedAt(const PictureProjection& picture, glm::dvec3 point);

/// Moves the texels of faces towards what lands on their centroids: before + coverage (colour -
/// before), in float. Channels are red, green and blue, further ones blue, but an opacity channel
/// moves towards 1. Nothing hides anything: which faces the picture reaches is up to the caller.
/// \param faces    each once
/// \param picture  as many pixels as it says (checked)
/// \return         what the faces held; those that are as before are left out
TexelPatch projectPicture(TexelStore& store,
                          const TriangleMesh& mesh,
                          std::span<const FaceId> faces,
                          const PictureProjection& picture,
                          Threads threads);

} // namespace trixel
