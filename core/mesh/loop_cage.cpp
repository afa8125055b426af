// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/loop_cage.h"

#include "core/mesh/loop_refinement.h"

#include <cmath>
#include <opensubdiv/far/topologyDescriptor.h>
#include <string>
#include <vector>

namespace trixel {

namespace {

namespace Far = OpenSubdiv::Far;
namespace Sdc = OpenSubdiv::Sdc;

Status checkFaces(const TriangleMesh& cage)
{
    for (std::size_t f = 0; f < cage.faceCount(); ++f) {
        const Triangle& t = cage.triangles[f];
        for (const std::uint32_t vertex : t) {
            if (vertex >= cage.positions.size()) {
                return contentsError("face " + std::to_string(f) + " has vertex " +
                                     std::to_string(vertex) + ", the cage has " +
                                     std::to_string(cage.positions.size()));
            }
        }
        if (repeatsVertex(t)) {
            return contentsError("face " + std::to_string(f) +
                                 " has a corner twice; a cage needs three different ones");
        }
    }
    return {};
}

Status checkVertices(const TriangleMesh& cage)
{
    std::vector<std::size_t> facesAt(cage.positions.size());
    for (const Triangle& t : cage.triangles) {
        for (const std::uint32_t vertex : t) {
            ++facesAt[vertex];
        }
    }
    for (std::size_t v = 0; v < cage.positions.size(); ++v) {
        const glm::vec3 p = cage.positions[v];
        if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z)) {
            return contentsError("vertex " + std::to_string(v) + " has no finite position");
        }
        if (facesAt[v] > kMaxLoopValence) {
            return contentsError("vertex " + std::to_string(v) + " has " +
                                 std::to_string(facesAt[v]) + " faces around it, at most " +
                                 std::to_string(kMaxLoopValence) + " can be refined");
        }
    }
    return {};
}

/// \param name  of what is sharp
Status
checkSharp(const TriangleMesh& cage, const std::string& name, std::uint32_t vertex, float sharpness)
{
    if (vertex >= cage.positions.size()) {
        return contentsError(name + " has vertex " + std::to_string(vertex) + ", the cage has " +
                             std::to_string(cage.positions.size()));
    }
    if (!(sharpness >= 0 && sharpness <= kSharp)) {
        return contentsError(name + " has sharpness " + std::to_string(sharpness) +
                             ", not 0 to 10");
    }
    return {};
}

} // namespace

Status checkLoopCage(const TriangleMesh& cage)
{
    if (Status status = checkFaces(cage); !status) {
        return status;
    }
    if (Status status = checkVertices(cage); !status) {
        return status;
    }
    if (cage.triangles.empty()) {
        return contentsError("the cage has no faces");
    }
    return {};
}

Status checkSharpness(const TriangleMesh& cage, const Sharpness& sharpness)
{
    for (std::size_t k = 0; k < sharpness.creases.size(); ++k) {
        const Crease& crease = sharpness.creases[k];
        const std::string name = "crease " + std::to_string(k + 1);
        for (const std::uint32_t vertex : {crease.from, crease.to}) {
            if (Status status = checkSharp(cage, name, vertex, crease.sharpness); !status) {
                return status;
            }
        }
    }
    for (std::size_t k = 0; k < sharpness.vertices.size(); ++k) {
        const SharpVertex& sharp = sharpness.vertices[k];
        const std::string name = "sharp vertex " + std::to_string(k + 1);
        if (Status status = checkSharp(cage, name, sharp.vertex, sharp.sharpness); !status) {
            return status;
        }
    }
    return {};
}

LoopRefiner makeLoopRefiner(const TriangleMesh& cage, const Sharpness& sharpness)
{
    const std::vector<int> corners(cage.faceCount(), 3);
    std::vector<int> vertices;
    vertices.reserve(3 * cage.faceCount());
    for (const Triangle& t : cage.triangles) {
        for (const std::uint32_t vertex : t) {
            vertices.push_back(static_cast<int>(vertex));
        }
    }
    std::vector<int> creaseEnds;
    std::vector<float> creaseWeights;
    for (const Crease& crease : sharpness.creases) {
        creaseEnds.push_back(static_cast<int>(crease.from));
        creaseEnds.push_back(static_cast<int>(crease.to));
        creaseWeights.push_back(crease.sharpness);
    }
    std::vector<int> sharpVertices;
    std::vector<float> vertexWeights;
    for (const SharpVertex& sharp : sharpness.vertices) {
        sharpVertices.push_back(static_cast<int>(sharp.vertex));
        vertexWeights.push_back(sharp.sharpness);
    }
    using Descriptor = Far::TopologyDescriptor;
    Descriptor descriptor;
    descriptor.numVertices = static_cast<int>(cage.positions.size());
    descriptor.numFaces = static_cast<int>(cage.faceCount());
    descriptor.numVertsPerFace = corners.data();
    descriptor.vertIndicesPerFace = vertices.data();
    descriptor.numCreases = static_cast<int>(creaseWeights.size());
    descriptor.creaseVertexIndexPairs = creaseEnds.data();
    descriptor.creaseWeights = creaseWeights.data();
    descriptor.numCorners = static_cast<int>(vertexWeights.size());
    descriptor.cornerVertexIndices = sharpVertices.data();
    descriptor.cornerWeights = vertexWeights.data();

    Sdc::Options scheme;
    scheme.SetVtxBoundaryInterpolation(Sdc::Options::VTX_BOUNDARY_EDGE_AND_CORNER);
    using Factory = Far::TopologyRefinerFactory<Descriptor>;
    return LoopRefiner(Factory::Create(descriptor, Factory::Options(Sdc::SCHEME_LOOP, scheme)));
}

} // namespace trixel
