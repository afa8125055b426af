// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/filter/face_net.h"

#include "core/filter/shape_on_edge.h"

namespace trixel {

FaceNet layNet(const TriangleMesh& mesh, const Adjacency& adjacency, FaceId face)
{
    const FaceShape shape = faceShapeOf(mesh.corners(face));
    return layNet(mesh, adjacency, LaidFace{face, {glm::dvec2(0), shape.e1, shape.e2}});
}

FaceNet layNet(const TriangleMesh& mesh, const Adjacency& adjacency, const LaidFace& centre)
{
    FaceNet net{centre, {}};
    for (const LocalEdge edge : kLocalEdges) {
        const auto neighbour = adjacency.neighbour(centre.face, edge);
        if (!neighbour) {
            continue;
        }
        const glm::dvec2 start = centre.corners[indexOf(edge)];
        const glm::dvec2 end = centre.corners[indexOf(nextEdge(edge))];
        const std::size_t theirs = indexOf(neighbour->edge);
        const FaceShape shape = faceShapeOf(mesh.corners(neighbour->face));
        LaidFace laid{neighbour->face, {}};
        laid.corners[theirs] = end;
        laid.corners[(theirs + 1) % 3] = start;
        laid.corners[(theirs + 2) % 3] = vertexBeyond(shape, theirs, start, end);
        net.across[indexOf(edge)] = laid;
    }
    return net;
}

} // namespace trixel
