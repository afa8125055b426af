// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/footprint/footprint.h"

namespace trixel {

/// A view that looks at one point of a face and can be tilted about it, from straight above to
/// along the face.
struct TiltedView
{
    double distance = 1; ///< of the eye to the point, world units
    double radiansPerPixel = 1e-3;
    glm::dvec2 towards{0, 1}; ///< where the eye leans, in (u,v) of the face; not zero
};

/// The ray of the pixel that sees the point.
/// \param uv       the point
/// \param degrees  0 sees the face from straight above, 90 along it; brought into [0, 89.99]
PixelRay tiltedRay(const TiltedView& view,
                   const std::array<glm::vec3, 3>& corners,
                   glm::dvec2 uv,
                   double degrees);

} // namespace trixel
