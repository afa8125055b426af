// SPDX-License-Identifier: GPL-3.0-or-later
//
// A face and its three neighbours unfolded into one plane.
#pragma once

#include "core/lattice/face_layout.h"
#include "core/mesh/adjacency.h"
#include "core/mesh/triangle_mesh.h"

#include <array>
#include <optional>

namespace trixel {

/// A face where it lies in the plane; it turns left.
struct LaidFace
{
    FaceId face{};
    std::array<glm::dvec2, 3> corners{}; ///< of V0, V1, V2

    FaceLayout layout() const { return FaceLayout::triangle(corners[0], corners[1], corners[2]); }
    bool operator==(const LaidFace&) const = default;
};

/// Neighbours are laid by the lengths of their own edges, in world units, as filters lay them
/// (`FaceShape`): nothing is stretched, so texels have the shapes that they have on the mesh. A
/// face without area is shown equilateral, on whichever edge it is laid. Where angles about a
/// vertex are wide, neighbours may overlap.
struct FaceNet
{
    LaidFace centre;
    std::array<std::optional<LaidFace>, 3> across{}; ///< by the centre's edges; nothing at a border

    bool operator==(const FaceNet&) const = default;
};

/// The face with V0 at the origin and V1 on the x axis, and what lies around it.
FaceNet layNet(const TriangleMesh& mesh, const Adjacency& adjacency, FaceId face);

/// The net around a face that stays where it lies, for instance as a neighbour in another net.
FaceNet layNet(const TriangleMesh& mesh, const Adjacency& adjacency, const LaidFace& centre);

} // namespace trixel
