// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/adjacency.h"
#include "core/mesh/triangle_mesh.h"

#include <string>
#include <vector>

namespace trixel {

/// What is unusual about a mesh. Nothing here is refused: every face keeps its number and can be
/// painted; what it costs is said by `describe`.
struct MeshReport
{
    /// An edge of three or more faces, or of two that run along it the same way.
    struct Edge
    {
        FaceId face{};
        LocalEdge edge{};
        bool operator==(const Edge&) const = default;
    };

    std::vector<Edge> nonManifoldEdges;       ///< once per face of the edge
    std::vector<FaceId> degenerateFaces;      ///< no area in float positions, or a repeated vertex
    std::vector<FaceId> duplicateFaces;       ///< same three distinct vertices as an earlier face
    std::vector<FaceId> flippedFaces;         ///< wound against most faces of their component
    std::vector<FaceId> isolatedFaces;        ///< all three edges are borders
    std::vector<FaceId> halfEdgeRefusedFaces; ///< not representable in the half-edge structure
    std::size_t borderEdges = 0;              ///< edges of one face only
    std::size_t unusedVertices = 0;           ///< vertices of no face
    std::size_t polygonsCut = 0;              ///< source polygons of more than three corners

    bool operator==(const MeshReport&) const = default;

    /// Nothing but borders, unused vertices and cut polygons.
    bool isClean() const;
    /// One line a finding: how many, the first few face numbers, and what it costs.
    std::vector<std::string> describe() const;
};

/// All but `halfEdgeRefusedFaces`, which `Surface` fills in. Lists are in ascending order.
/// \param adjacency  of the mesh's triangles
MeshReport inspectMesh(const TriangleMesh& mesh, const Adjacency& adjacency);

} // namespace trixel
