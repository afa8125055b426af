// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/filter/local_surface.h"

#include <queue>

#include "core/mesh/triangle_geometry.h"

#include <algorithm>
#include <cmath>
#include <glm/vec3.hpp>
#include <unordered_map>
#include <unordered_set>

namespace trixel {
namespace {

struct Waiting
{
    double distance = 0;
    FaceId face{};

    bool operator<(const Waiting& other) const
    {
        return distance != other.distance ? distance > other.distance : face > other.face;
    }
};

bool shareVertex(const Triangle& a, const Triangle& b)
{
    return std::ranges::any_of(
        a, [&](std::uint32_t vertex) { return std::ranges::find(b, vertex) != b.end(); });
}

/// Nearest first.
std::vector<FaceId> facesAbout(const TriangleMesh& mesh,
                               const Adjacency& adjacency,
                               FaceId hit,
                               glm::dvec3 centre,
                               double reach,
                               std::size_t mostFaces,
                               bool& isCut)
{
    std::vector<FaceId> faces;
    std::unordered_set<std::uint32_t> seen;
    std::priority_queue<Waiting> waiting;
    const Triangle& own = mesh.triangles[indexOf(hit)];
    const auto offer = [&](FaceId face) {
        if (!seen.insert(static_cast<std::uint32_t>(face)).second) {
            return;
        }
        const bool about = shareVertex(mesh.triangles[indexOf(face)], own);
        const double distance =
            face == hit ? 0
                        : std::sqrt(nearestOnTriangle(mesh.corners(face), centre).distanceSquared);
        if (about || distance <= reach) {
            waiting.push({about ? 0 : distance, face});
        }
    };
    offer(hit);
    while (!waiting.empty() && faces.size() < mostFaces) {
        const FaceId face = waiting.top().face;
        waiting.pop();
        faces.push_back(face);
        for (const LocalEdge edge : kLocalEdges) {
            if (const auto across = adjacency.neighbour(face, edge)) {
                offer(across->face);
            }
        }
    }
    isCut = !waiting.empty();
    return faces;
}

} // namespace

LocalSurface localSurface(const TriangleMesh& mesh,
                          const Adjacency& adjacency,
                          FaceId face,
                          glm::dvec2 uv,
                          double reach,
                          std::size_t mostFaces)
{
    check(indexOf(face) < mesh.faceCount(), "face exists");
    const auto corners = mesh.corners(face);
    const glm::dvec3 centre = glm::dvec3(corners[0]) +
                              uv.x * (glm::dvec3(corners[1]) - glm::dvec3(corners[0])) +
                              uv.y * (glm::dvec3(corners[2]) - glm::dvec3(corners[0]));
    LocalSurface local;
    local.faces = facesAbout(
        mesh, adjacency, face, centre, reach, std::max<std::size_t>(mostFaces, 1), local.isCut);
    std::ranges::sort(local.faces); // whoever is lowest there is lowest here

    std::unordered_map<std::uint32_t, FaceId> own;
    TriangleMesh part;
    for (std::size_t k = 0; k < local.faces.size(); ++k) {
        own.emplace(static_cast<std::uint32_t>(local.faces[k]), faceId(k));
        const auto first = static_cast<std::uint32_t>(part.positions.size());
        part.triangles.push_back({first, first + 1, first + 2});
        for (const glm::vec3& corner : mesh.corners(local.faces[k])) {
            part.positions.push_back(corner);
        }
    }
    Adjacency neighbours(local.faces.size());
    for (std::size_t k = 0; k < local.faces.size(); ++k) {
        for (const LocalEdge edge : kLocalEdges) {
            const auto across = adjacency.neighbour(local.faces[k], edge);
            if (!across) {
                continue;
            }
            const auto other = own.find(static_cast<std::uint32_t>(across->face));
            if (other != own.end()) {
                neighbours.connect(faceId(k), edge, other->second, across->edge);
            }
        }
    }
    local.hit = own.at(static_cast<std::uint32_t>(face));
    local.surface = FilterSurface::fromMesh(part, std::move(neighbours));
    return local;
}

} // namespace trixel
