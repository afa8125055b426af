// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/triangle_mesh.h"
#include "core/study/views/view_camera.h"

#include <vector>

namespace trixel {

/// The mesh as a Loop cage, subdivided so many times.
struct SubdivisionError
{
    int steps = 0;
    std::size_t faces = 0;
    /// How far the middles of the edges lie from the limit surface, at the worst, in pixels of the
    /// finest covered view there.
    double pixels = 0;
};

/// Far enough from the limit surface to be seen at an outline.
inline constexpr double kSubdivisionPixels = 0.5;

/// From no subdivision on, until the error is within `most` pixels or a further step would make
/// more than `mostFaces`. Vertices are taken to the limit at every step (`loopRefined`), so that
/// what is left is the height of the facets' arcs. Edges that no view frames do not count. Empty
/// where the mesh cannot be a cage (`loopRefined` fails).
std::vector<SubdivisionError> subdivisionErrors(const TriangleMesh& cage,
                                                const SceneViews& views,
                                                double most = kSubdivisionPixels,
                                                std::size_t mostFaces = std::size_t{1} << 20U);

} // namespace trixel
