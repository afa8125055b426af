// SPDX-License-Identifier: GPL-3.0-or-later
//
// Where the points of a surface lie in a 2D image: one interface for all ways of laying an image
// onto a mesh.
#pragma once

#include "core/base/ids.h"
#include "core/footprint/footprint.h"

#include <glm/vec2.hpp>

namespace trixel {

/// Where a point of a face lies in the image.
struct ImagePlace
{
    bool lands = false; ///< whether the image reaches the point at all
    /// s to the right, t upwards, the image over the unit square; beyond it for sets of tiles.
    glm::dvec2 st{0};
    /// Change of (s,t) for a step along u, and for one along v.
    Footprint footprint;
};

/// Const calls may come from several threads.
class Mapping
{
public:
    virtual ~Mapping() = default;

    /// \param uv    in the face, not on its border for mappings that have seams there
    /// \param step  in u and in v: how far it is to the next texel
    virtual ImagePlace at(FaceId face, glm::dvec2 uv, double step) const = 0;
};

} // namespace trixel
