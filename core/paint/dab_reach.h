// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/surface.h"
#include "core/paint/dab.h"

#include <memory>
#include <vector>

namespace trixel {

/// Which faces a dab may paint, by distance and by the way they face.
class DabReach
{
public:
    DabReach(std::shared_ptr<const Surface> surface, bool paintThrough);

    /// Unit normal, turned if the report says that the face is wound against its neighbours; zero
    /// for a face that faces no way: one without area, or one that coincides with another.
    glm::vec3 normalOf(FaceId face) const;

    /// Faces within the dab's radius, in ascending order; without paint-through those whose
    /// normal is more than about a hundred degrees off the dab's are left out.
    void facesOf(const Dab& dab, std::vector<FaceId>& faces) const;

private:
    std::shared_ptr<const Surface> m_surface;
    bool m_paintThrough;
    std::vector<FaceId> m_flipped;    ///< ascending
    std::vector<FaceId> m_facesNoWay; ///< ascending
};

} // namespace trixel
