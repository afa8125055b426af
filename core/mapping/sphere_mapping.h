// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "core/mapping/mapping.h"
#include "core/mesh/triangle_mesh.h"

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

namespace trixel {

/// What `SphereMapping` takes as `turned`, for a sphere whose poles lie on an axis. The image's
/// middle lies towards +z, or towards -y where the axis is along z, and then turned.
/// \param axis   from the lower pole to the upper, of any length; fails if it is 0 or not finite
/// \param turn   degrees about the axis
Result<glm::dmat3> sphereTurn(glm::dvec3 axis, double turn);

/// By the direction from a centre: `sphereUv`. The image goes round (repeats in s) and ends at the
/// poles; footprints do not see the seam and are limited to one period at the poles.
class SphereMapping final : public Mapping
{
public:
    /// \param mesh    outlives this
    /// \param turned  from the world to the sphere, whose axis is y and whose +z the image's middle
    ///                lies towards
    SphereMapping(const TriangleMesh& mesh, glm::dvec3 centre, const glm::dmat3& turned);

    ImagePlace at(FaceId face, glm::dvec2 uv, double step) const override;

private:
    const TriangleMesh& m_mesh;
    glm::dvec3 m_centre;
    glm::dmat3 m_turned;
};

} // namespace trixel
