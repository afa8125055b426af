// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/adjacency.h"
#include "core/mesh/triangle_mesh.h"

#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace OpenMesh {
class TriConnectivity;
}

namespace trixel {

/// The faces of a mesh as an OpenMesh half-edge structure: connectivity only (no positions, no
/// status), 16 bytes a half-edge. Vertex numbers are those of the mesh, and the faces across an
/// edge are those of the `Adjacency`; an edge that is a border there is one here, so an edge of
/// three faces is three border edges between the same vertices.
///
/// Some faces are refused (and keep their FaceId everywhere else): those that repeat a vertex, and
/// of a vertex where a closed ring of faces meets other faces, one face of each such ring, the one
/// with the highest number. A vertex may join any number of open fans.
class HalfEdges
{
public:
    HalfEdges();
    /// \param adjacency  of `triangles`
    /// Takes time and memory linear in faces and vertices, whatever their shape.
    HalfEdges(std::span<const Triangle> triangles,
              std::size_t vertexCount,
              const Adjacency& adjacency);
    ~HalfEdges();
    HalfEdges(HalfEdges&&) noexcept;
    HalfEdges& operator=(HalfEdges&&) noexcept;

    /// For callers that include OpenMesh's headers. Never changes.
    const OpenMesh::TriConnectivity& structure() const { return *m_structure; }

    /// In ascending order.
    std::span<const FaceId> refusedFaces() const { return m_refused; }

    /// Number of a face in the structure; nothing for a refused one. The half-edges of a face run
    /// E0, E1, E2 from its `halfedge_handle`.
    std::optional<int> structureFace(FaceId face) const;

    /// The face of the mesh that a face of the structure stands for.
    FaceId meshFace(int structureFace) const;

    std::size_t memoryBytes() const;

private:
    std::unique_ptr<OpenMesh::TriConnectivity> m_structure;
    std::vector<FaceId> m_refused;
};

} // namespace trixel
