// SPDX-License-Identifier: GPL-3.0-or-later
//
// Which face of one mesh is which of another that has the same faces in another order, begun at
// other corners, or wound the other way round.
#pragma once

#include "core/base/ids.h"
#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/lattice/corner_order.h"
#include "core/mesh/adjacency.h"
#include "core/mesh/triangle_mesh.h"

#include <vector>

namespace trixel {

/// A face of the other mesh, and how its corners are numbered there.
struct MatchedFace
{
    FaceId face{};
    CornerOrder corners = kSameCorners;

    bool operator==(const MatchedFace&) const = default;
};

/// One for each face of the mesh; each face of the other occurs once.
using FaceMatch = std::vector<MatchedFace>;

/// Matches faces whose corners lie at the same places: to the bit, or, where that does not bring
/// all together, within a hundred-thousandth of the mesh's size. Of faces that lie on each other
/// those of the same winding belong together. Corners of a face that coincide are told apart by
/// their order alone.
/// Errors: other numbers of faces; a face without a counterpart, named; several faces at one place
/// that nothing tells apart; cancelled.
Result<FaceMatch>
matchByPositions(const TriangleMesh& mesh, const TriangleMesh& other, Progress& progress);

/// Matches faces by who neighbours whom alone, wherever their corners lie. All faces of a connected
/// part are wound like in the other mesh, or all the other way round.
/// Errors: other numbers of faces; no match; several (a mesh with a symmetry, or parts that are
/// alike); cancelled.
Result<FaceMatch>
matchByNeighbours(const Adjacency& mesh, const Adjacency& other, Progress& progress);

/// Whether every face is its own counterpart.
bool isIdentity(const FaceMatch& match);

} // namespace trixel
