// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/ptx_mesh_match.h"

#include "core/base/check.h"

#include <algorithm>
#include <array>
#include <tuple>

namespace trixel {

namespace {

using Neighbours = std::array<std::int64_t, 3>; // face numbers, -1 at a border

// The edges of one face as the file and as the mesh have them.
struct FaceLinks
{
    Neighbours inFile{-1, -1, -1};
    Neighbours inMesh{-1, -1, -1};
    std::array<int, 3> edgesInFile{};
    std::array<int, 3> edgesInMesh{};
};

FaceLinks linksOf(const PtxFaceInfo& info, const Adjacency& adjacency, FaceId face)
{
    FaceLinks links;
    for (const LocalEdge edge : kLocalEdges) {
        const std::size_t e = indexOf(edge);
        links.inFile[e] = info.adjacentFaces[e];
        links.edgesInFile[e] = info.adjacentFaces[e] < 0 ? 0 : info.adjacentEdge(e);
        if (const auto neighbour = adjacency.neighbour(face, edge)) {
            links.inMesh[e] = static_cast<std::int64_t>(indexOf(neighbour->face));
            links.edgesInMesh[e] = static_cast<int>(indexOf(neighbour->edge));
        }
    }
    return links;
}

bool isRotation(const Neighbours& a, Neighbours b)
{
    for (int k = 0; k < 3; ++k) {
        std::rotate(b.begin(), b.begin() + 1, b.end());
        if (a == b) {
            return true;
        }
    }
    return false;
}

std::string named(const Neighbours& neighbours)
{
    std::string text;
    for (const std::int64_t face : neighbours) {
        text += text.empty() ? "" : ", ";
        text += face < 0 ? "none" : std::to_string(face);
    }
    return text;
}

std::string describe(std::size_t face, const FaceLinks& links)
{
    const std::string name = "face " + std::to_string(face);
    if (links.inFile == links.inMesh) {
        return name +
               " meets the same faces in the texture and in the mesh, but across other edges "
               "of theirs: their first corners or winding differ";
    }
    const std::string both = name + " has the neighbours " + named(links.inFile) +
                             " in the texture and " + named(links.inMesh) + " in the mesh";
    if (isRotation(links.inFile, links.inMesh)) {
        return both + ": the mesh's face starts at another corner";
    }
    Neighbours reversed = links.inMesh;
    std::ranges::reverse(reversed);
    if (isRotation(links.inFile, reversed)) {
        return both + ": the mesh's face is wound the other way round";
    }
    return both + ": the mesh's faces are in another order or winding, or are others";
}

} // namespace

void matchPtxWithMesh(std::span<const PtxFaceInfo> infos,
                      const Adjacency& adjacency,
                      std::span<const MeshReport::Edge> nonManifoldEdges,
                      const std::function<bool(std::string)>& visit)
{
    check(infos.size() == adjacency.faceCount(), "as many faces");
    const auto isNonManifold = [&](std::size_t face, std::size_t edge) {
        const auto key = [](const MeshReport::Edge& e) { return std::tuple(e.face, e.edge); };
        return std::ranges::binary_search(
            nonManifoldEdges, std::tuple(faceId(face), static_cast<LocalEdge>(edge)), {}, key);
    };
    for (std::size_t face = 0; face < infos.size(); ++face) {
        const FaceLinks links = linksOf(infos[face], adjacency, faceId(face));
        if (links.inFile == Neighbours{-1, -1, -1}) {
            continue;
        }
        bool differs = false;
        for (std::size_t e = 0; e < 3; ++e) {
            const bool same =
                links.inFile[e] == links.inMesh[e] && links.edgesInFile[e] == links.edgesInMesh[e];
            differs = differs || (!same && !(links.inMesh[e] < 0 && isNonManifold(face, e)));
        }
        if (differs && !visit(describe(face, links))) {
            return;
        }
    }
}

} // namespace trixel
