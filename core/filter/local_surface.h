// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/filter/filter_surface.h"

#include <cstddef>
#include <vector>

namespace trixel {

/// The faces about a point as a small surface of their own, for work that must not wait for what
/// filters know of the whole mesh.
struct LocalSurface
{
    std::vector<FaceId> faces; ///< as the mesh numbers them, ascending; place k is local face k
    FaceId hit{};              ///< the point's face, as it is numbered here
    FilterSurface surface;
    bool isCut = false; ///< there were more faces than room
};

/// The faces within `reach` of a point (through space, world units) and all that share a vertex
/// with its face, as far as they hang together by edges. About the face itself everything that
/// filters measure is as on the whole mesh.
/// \param face       exists (checked)
/// \param mostFaces  at least 1; the nearest stay
LocalSurface localSurface(const TriangleMesh& mesh,
                          const Adjacency& adjacency,
                          FaceId face,
                          glm::dvec2 uv,
                          double reach,
                          std::size_t mostFaces);

} // namespace trixel
