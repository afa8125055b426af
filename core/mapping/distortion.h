// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/parallel.h"
#include "core/mapping/mapping.h"
#include "core/mesh/triangle_mesh.h"

#include <glm/vec2.hpp>
#include <vector>

namespace trixel {

/// How a mapping stretches the image at a point of the surface: of all directions there, the most
/// and the fewest pixels that a world unit takes up. NaN where the image does not reach, and where
/// a face has no area.
struct MapStretch
{
    float most = 0;   ///< pixels per world unit
    float fewest = 0; ///< <= most; 0 where the mapping folds the surface onto a line

    /// 1 where the image is only scaled; infinite where it is smeared along one direction.
    float anisotropy() const { return most / fewest; }
    /// Pixels per square of a world unit.
    float density() const { return most * fewest; }
};

/// \param uv         in the face; poles and seams of the mapping excepted
/// \param imageSize  in pixels
MapStretch stretchAt(const Mapping& mapping,
                     const TriangleMesh& mesh,
                     FaceId face,
                     glm::dvec2 uv,
                     glm::dvec2 imageSize);

/// For a colour at every corner: three a face, each taken a hundredth of the way into the face,
/// where mappings that are singular at a vertex still have a value. The result does not depend on
/// the number of threads.
std::vector<MapStretch> cornerStretch(const Mapping& mapping,
                                      const TriangleMesh& mesh,
                                      glm::dvec2 imageSize,
                                      Threads threads);

/// The middle of a mapping's densities, weighed by nothing: what to call "as everywhere else" when
/// colouring by density. NaN where the image reaches nothing.
float medianDensity(const std::vector<MapStretch>& stretch);

} // namespace trixel
