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

Status checkCreases(const TriangleMesh& cage, std::span<const Crease> creases)
{
    for (std::size_t k = 0; k < creases.size(); ++k) {
        const Crease& crease = creases[k];
        for (const std::uint32_t vertex : {crease.from, crease.to}) {
            if (vertex >= cage.positions.size()) {
                return contentsError("crease " + std::to_string(k + 1) + " has vertex " +
                                     std::to_string(vertex) + ", the cage has " +
                                     std::to_string(cage.positions.size()));
            }
        }
        if (!(crease.sharpness >= 0 && crease.sharpness <= kSharp)) {
            return contentsError("crease " + std::to_string(k + 1) + " has sharpness " +
                                 std::to_string(crease.sharpness) + ", not 0 to 10");
        }
    }
    return {};
}

LoopRefiner makeLoopRefiner(const TriangleMesh& cage, std::span<const Crease> creases)
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
    std::vector<float> sharpness;
    for (const Crease& crease : creases) {
        creaseEnds.push_back(static_cast<int>(crease.from));
        creaseEnds.push_back(static_cast<int>(crease.to));
        sharpness.push_back(crease.sharpness);
    }
    using Descriptor = Far::TopologyDescriptor;
    Descriptor descriptor;
    descriptor.numVertices = static_cast<int>(cage.positions.size());
    descriptor.numFaces = static_cast<int>(cage.faceCount());
    descriptor.numVertsPerFace = corners.data();
    descriptor.vertIndicesPerFace = vertices.data();
    descriptor.numCreases = static_cast<int>(creases.size());
    descriptor.creaseVertexIndexPairs = creaseEnds.data();
    descriptor.creaseWeights = sharpness.data();

    Sdc::Options scheme;
    scheme.SetVtxBoundaryInterpolation(Sdc::Options::VTX_BOUNDARY_EDGE_AND_CORNER);
    using Factory = Far::TopologyRefinerFactory<Descriptor>;
    return LoopRefiner(Factory::Create(descriptor, Factory::Options(Sdc::SCHEME_LOOP, scheme)));
}

} // namespace trixel
