// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/limit_mesh.h"
#include "core/mesh/surface.h"
#include "core/paint/dab.h"

#include <memory>
#include <vector>

namespace trixel {

/// Cosine below which a surface faces away from a dab: it still goes round a sharp convex edge.
inline constexpr float kFacesAway = -0.2F;

/// Which faces a dab may paint, by distance and by the way they face.
class DabReach
{
public:
    /// \param limit  to paint on instead; null for the cage
    DabReach(std::shared_ptr<const Surface> surface,
             bool paintThrough,
             std::shared_ptr<const LimitMesh> limit = {});

    /// Unit normal, turned if the report says that the face is wound against its neighbours; zero
    /// for a face that faces no way: one without area, or one that coincides with another.
    glm::vec3 normalOf(FaceId face) const;
    /// The same of a face's normal at a point of the limit surface.
    glm::vec3 turned(FaceId face, glm::vec3 normal) const;

    /// Faces within the dab's radius, in ascending order; without paint-through those whose
    /// normal is more than about a hundred degrees off the dab's are left out. On the limit
    /// surface none are: there texels are asked one by one.
    void facesOf(const Dab& dab, std::vector<FaceId>& faces) const;

private:
    std::shared_ptr<const Surface> m_surface;
    std::shared_ptr<const LimitMesh> m_limit;
    bool m_paintThrough;
    std::vector<FaceId> m_flipped;    ///< ascending
    std::vector<FaceId> m_facesNoWay; ///< ascending
};

} // namespace trixel
