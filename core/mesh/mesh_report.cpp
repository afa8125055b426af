// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/mesh_report.h"

#include "core/base/check.h"
#include "core/mesh/mesh_winding.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <tuple>

namespace trixel {
namespace {

// A side of an edge that the adjacency calls a border.
struct OpenSide
{
    std::uint32_t low = 0; // vertices of the edge
    std::uint32_t high = 0;
    FaceId face{};
    LocalEdge edge{};
    bool ascending = false; // runs from low to high

    auto key() const { return std::tuple(low, high, face, edge); }
    bool sameEdge(const OpenSide& b) const { return low == b.low && high == b.high; }
};

std::vector<OpenSide> openSides(const TriangleMesh& mesh, const Adjacency& adjacency)
{
    std::vector<OpenSide> sides;
    for (std::size_t f = 0; f < mesh.faceCount(); ++f) {
        const Triangle& t = mesh.triangles[f];
        if (repeatsVertex(t)) {
            continue;
        }
        for (const LocalEdge edge : kLocalEdges) {
            if (!adjacency.neighbour(faceId(f), edge)) {
                const std::uint32_t from = t[indexOf(edge)];
                const std::uint32_t to = t[(indexOf(edge) + 1) % 3];
                sides.push_back(
                    {std::min(from, to), std::max(from, to), faceId(f), edge, from < to});
            }
        }
    }
    std::sort(sides.begin(), sides.end(), [](const OpenSide& a, const OpenSide& b) {
        return a.key() < b.key();
    });
    return sides;
}

// Sorts borders from non-manifold edges; collects the pairs of faces that run along an edge the
// same way, for the winding.
std::vector<FacePair> findOpenEdges(const std::vector<OpenSide>& sides, MeshReport& report)
{
    std::vector<FacePair> opposed;
    for (std::size_t i = 0; i < sides.size();) {
        std::size_t next = i + 1;
        while (next < sides.size() && sides[next].sameEdge(sides[i])) {
            ++next;
        }
        if (next - i == 1) {
            ++report.borderEdges;
        } else {
            for (std::size_t k = i; k < next; ++k) {
                report.nonManifoldEdges.push_back({sides[k].face, sides[k].edge});
            }
        }
        if (next - i == 2) {
            opposed.push_back({sides[i].face, sides[i + 1].face});
        }
        i = next;
    }
    std::sort(report.nonManifoldEdges.begin(),
              report.nonManifoldEdges.end(),
              [](const MeshReport::Edge& a, const MeshReport::Edge& b) {
                  return std::tuple(a.face, a.edge) < std::tuple(b.face, b.edge);
              });
    return opposed;
}

// No area as far as float positions can tell: the height over the longest edge is below the
// spacing of floats at the face's largest coordinate.
bool isDegenerate(const TriangleMesh& mesh, std::size_t face)
{
    if (repeatsVertex(mesh.triangles[face])) {
        return true;
    }
    const auto corners = mesh.corners(faceId(face));
    const glm::dvec3 a(corners[0]);
    const glm::dvec3 b(corners[1]);
    const glm::dvec3 c(corners[2]);
    const glm::dvec3 largest = glm::max(glm::abs(a), glm::max(glm::abs(b), glm::abs(c)));
    const double spacing = std::ldexp(std::max({largest.x, largest.y, largest.z}), -24);
    const double longest =
        std::max({glm::dot(b - a, b - a), glm::dot(c - b, c - b), glm::dot(a - c, a - c)});
    const glm::dvec3 doubledArea = glm::cross(b - a, c - a);
    return glm::dot(doubledArea, doubledArea) <= longest * spacing * spacing;
}

Triangle sortedTriangle(Triangle t)
{
    std::sort(t.begin(), t.end());
    return t;
}

// A duplicate shares each edge with its twin: the edge either has too many faces to be joined, or
// joins exactly the two.
bool mayBeDuplicate(const TriangleMesh& mesh, const Adjacency& adjacency, std::size_t face)
{
    const Triangle t = sortedTriangle(mesh.triangles[face]);
    return std::all_of(std::begin(kLocalEdges), std::end(kLocalEdges), [&](LocalEdge edge) {
        const auto other = adjacency.neighbour(faceId(face), edge);
        return !other || sortedTriangle(mesh.triangles[indexOf(other->face)]) == t;
    });
}

std::vector<FaceId> findDuplicates(const TriangleMesh& mesh, const Adjacency& adjacency)
{
    std::vector<std::pair<Triangle, FaceId>> candidates;
    for (std::size_t f = 0; f < mesh.faceCount(); ++f) {
        if (!repeatsVertex(mesh.triangles[f]) && mayBeDuplicate(mesh, adjacency, f)) {
            candidates.emplace_back(sortedTriangle(mesh.triangles[f]), faceId(f));
        }
    }
    std::sort(candidates.begin(), candidates.end());
    std::vector<FaceId> duplicates;
    for (std::size_t i = 1; i < candidates.size(); ++i) {
        if (candidates[i].first == candidates[i - 1].first) {
            duplicates.push_back(candidates[i].second);
        }
    }
    std::sort(duplicates.begin(), duplicates.end());
    return duplicates;
}

bool isIsolated(const Adjacency& adjacency, std::size_t face)
{
    return std::none_of(std::begin(kLocalEdges), std::end(kLocalEdges), [&](LocalEdge edge) {
        return adjacency.neighbour(faceId(face), edge).has_value();
    });
}

std::size_t countUnusedVertices(const TriangleMesh& mesh)
{
    std::vector<bool> used(mesh.positions.size(), false);
    for (const Triangle& t : mesh.triangles) {
        for (const std::uint32_t vertex : t) {
            used[vertex] = true;
        }
    }
    return static_cast<std::size_t>(std::count(used.begin(), used.end(), false));
}

// Triangles cut from one polygon follow each other.
std::size_t countPolygonsCut(const std::vector<std::uint32_t>& sourceFaces)
{
    std::size_t polygons = 0;
    for (std::size_t i = 1; i < sourceFaces.size(); ++i) {
        const bool second = sourceFaces[i] == sourceFaces[i - 1] &&
                            (i == 1 || sourceFaces[i - 2] != sourceFaces[i]);
        polygons += second ? 1 : 0;
    }
    return polygons;
}

} // namespace

MeshReport inspectMesh(const TriangleMesh& mesh, const Adjacency& adjacency)
{
    check(adjacency.faceCount() == mesh.faceCount(), "adjacency of this mesh");
    MeshReport report;
    const std::vector<FacePair> opposed = findOpenEdges(openSides(mesh, adjacency), report);
    for (std::size_t f = 0; f < mesh.faceCount(); ++f) {
        if (isDegenerate(mesh, f)) {
            report.degenerateFaces.push_back(faceId(f));
        }
        if (isIsolated(adjacency, f)) {
            report.isolatedFaces.push_back(faceId(f));
        }
    }
    report.duplicateFaces = findDuplicates(mesh, adjacency);
    report.flippedFaces = findFlippedFaces(adjacency, opposed);
    report.unusedVertices = countUnusedVertices(mesh);
    report.polygonsCut = countPolygonsCut(mesh.sourceFaces);
    return report;
}

bool MeshReport::isClean() const
{
    return nonManifoldEdges.empty() && degenerateFaces.empty() && duplicateFaces.empty() &&
           flippedFaces.empty() && isolatedFaces.empty() && halfEdgeRefusedFaces.empty();
}

} // namespace trixel
