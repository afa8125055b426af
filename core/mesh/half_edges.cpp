// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/half_edges.h"

#include "core/base/check.h"
#include "core/base/parallel.h"

#include <OpenMesh/Core/Mesh/TriConnectivity.hh>
#include <algorithm>
#include <atomic>

namespace trixel {
namespace {

using Structure = OpenMesh::TriConnectivity;
using HalfEdge = OpenMesh::HalfedgeHandle;

constexpr std::size_t kVertexGrain = std::size_t{1} << 15U;
// OpenMesh numbers half-edges by int, and a face may bring six.
constexpr std::size_t kMaxStructureFaces = 0x7FFFFFFFU / 6U;

OpenMesh::VertexHandle vertexHandle(std::size_t vertex)
{
    return OpenMesh::VertexHandle(static_cast<int>(vertex));
}

// Fills an OpenMesh structure straight from the adjacency. OpenMesh's own add_face searches among
// the faces of each vertex: 0.24 s for a million faces, and quadratic for one huge fan.
class Builder
{
public:
    Builder(std::span<const Triangle> triangles,
            std::size_t vertexCount,
            const Adjacency& adjacency,
            const std::vector<bool>& refused)
        : m_triangles(triangles)
        , m_adjacency(adjacency)
        , m_refused(refused)
        , m_allKept(std::find(refused.begin(), refused.end(), true) == refused.end())
        , m_structure(std::make_unique<Structure>())
        , m_openCorners(vertexCount, 0)
    {
        m_structure->resize(vertexCount, countEdges(), countFaces());
        addFaces();
        linkBorders();
    }

    std::unique_ptr<Structure> take() { return std::move(m_structure); }

    // Vertices where a closed ring of faces meets any other face.
    std::vector<bool> crowdedVertices() const;

    // Refuses a face of each closed ring at those vertices.
    void openRings(const std::vector<bool>& crowded, std::vector<bool>& refused) const;

private:
    std::size_t countFaces() const
    {
        return static_cast<std::size_t>(std::count(m_refused.begin(), m_refused.end(), false));
    }

    std::optional<EdgeNeighbour> neighbour(FaceId face, LocalEdge edge) const
    {
        const auto other = m_adjacency.neighbour(face, edge);
        return m_allKept || !other || !m_refused[indexOf(other->face)] ? other : std::nullopt;
    }

    std::size_t countEdges() const;
    void addFaces();
    void linkBorders();
    HalfEdge nextOpen(HalfEdge border);
    std::uint32_t ringSize(HalfEdge outgoing) const;
    bool isAloneInRing(std::size_t vertex, std::uint32_t corners) const;

    std::span<const Triangle> m_triangles;
    const Adjacency& m_adjacency;
    const std::vector<bool>& m_refused;
    bool m_allKept;
    std::unique_ptr<Structure> m_structure;
    std::vector<HalfEdge> m_borders;
    std::vector<std::uint32_t> m_openCorners; // of each vertex: corners in fans with two ends
};

std::size_t Builder::countEdges() const
{
    std::size_t sides = 0;
    std::size_t borders = 0;
    for (std::size_t f = 0; f < m_triangles.size(); ++f) {
        if (m_refused[f]) {
            continue;
        }
        sides += 3;
        for (const LocalEdge edge : kLocalEdges) {
            borders += neighbour(faceId(f), edge) ? 0 : 1;
        }
    }
    return (sides + borders) / 2;
}

// Half-edge 2k runs along edge k as its face of lower number does, 2k + 1 comes back.
void Builder::addFaces()
{
    std::vector<int> halfEdges(3 * m_triangles.size());
    int edges = 0;
    int faces = 0;
    for (std::size_t f = 0; f < m_triangles.size(); ++f) {
        if (m_refused[f]) {
            continue;
        }
        const Triangle& t = m_triangles[f];
        for (const LocalEdge edge : kLocalEdges) {
            const std::size_t e = indexOf(edge);
            const auto other = neighbour(faceId(f), edge);
            if (!other || indexOf(other->face) > f) {
                const HalfEdge out(2 * edges);
                const HalfEdge back(2 * edges + 1);
                ++edges;
                halfEdges[3 * f + e] = out.idx();
                m_structure->set_vertex_handle(out, vertexHandle(t[(e + 1) % 3]));
                m_structure->set_vertex_handle(back, vertexHandle(t[e]));
                m_structure->set_halfedge_handle(vertexHandle(t[e]), out);
                m_structure->set_halfedge_handle(vertexHandle(t[(e + 1) % 3]), back);
                if (!other) {
                    m_borders.push_back(back);
                } else {
                    halfEdges[3 * indexOf(other->face) + indexOf(other->edge)] = back.idx();
                }
            }
        }
        const OpenMesh::FaceHandle face(faces++);
        m_structure->set_halfedge_handle(face, HalfEdge(halfEdges[3 * f]));
        for (std::size_t e = 0; e < 3; ++e) {
            const HalfEdge here(halfEdges[3 * f + e]);
            m_structure->set_face_handle(here, face);
            m_structure->set_next_halfedge_handle(here, HalfEdge(halfEdges[3 * f + (e + 1) % 3]));
        }
    }
}

// The border half-edge that leaves, at the other end of the fan, the vertex where `border` arrives.
HalfEdge Builder::nextOpen(HalfEdge border)
{
    std::uint32_t& corners =
        m_openCorners[static_cast<std::size_t>(m_structure->to_vertex_handle(border).idx())];
    HalfEdge outgoing = m_structure->opposite_halfedge_handle(border);
    while (!m_structure->is_boundary(outgoing)) {
        ++corners;
        outgoing = m_structure->ccw_rotated_halfedge_handle(outgoing);
    }
    return outgoing;
}

// Where several fans meet at a vertex, the border runs from each into the next, so that going round
// the vertex visits them all.
void Builder::linkBorders()
{
    for (const HalfEdge border : m_borders) {
        const auto vertex = m_structure->to_vertex_handle(border);
        const bool first = m_openCorners[static_cast<std::size_t>(vertex.idx())] == 0;
        const HalfEdge outgoing = nextOpen(border);
        if (first) {
            m_structure->set_next_halfedge_handle(border, outgoing);
        } else {
            const HalfEdge earlier = m_structure->halfedge_handle(vertex);
            m_structure->set_next_halfedge_handle(m_structure->prev_halfedge_handle(earlier),
                                                  outgoing);
            m_structure->set_next_halfedge_handle(border, earlier);
        }
        m_structure->set_halfedge_handle(vertex, outgoing);
    }
}

// Corners of the closed ring that a half-edge leaves from the middle of.
std::uint32_t Builder::ringSize(HalfEdge outgoing) const
{
    std::uint32_t corners = 0;
    HalfEdge at = outgoing;
    do {
        ++corners;
        at = m_structure->ccw_rotated_halfedge_handle(at);
    } while (at != outgoing);
    return corners;
}

bool Builder::isAloneInRing(std::size_t vertex, std::uint32_t corners) const
{
    return m_openCorners[vertex] == 0 &&
           ringSize(m_structure->halfedge_handle(vertexHandle(vertex))) == corners;
}

std::vector<bool> Builder::crowdedVertices() const
{
    std::vector<std::uint32_t> corners(m_openCorners.size(), 0);
    for (std::size_t f = 0; f < m_triangles.size(); ++f) {
        if (!m_refused[f]) {
            for (const std::uint32_t vertex : m_triangles[f]) {
                ++corners[vertex];
            }
        }
    }
    std::vector<char> isCrowded(corners.size(), 0); // bytes, which threads can write side by side
    std::atomic<bool> any{false};
    parallelFor(corners.size(), kVertexGrain, Threads::all(), [&](std::size_t v, std::size_t end) {
        for (; v < end; ++v) {
            if (corners[v] != m_openCorners[v] && !isAloneInRing(v, corners[v])) {
                isCrowded[v] = 1;
                any = true;
            }
        }
    });
    return any ? std::vector<bool>(isCrowded.begin(), isCrowded.end()) : std::vector<bool>();
}

void Builder::openRings(const std::vector<bool>& crowded, std::vector<bool>& refused) const
{
    // m_refused is `refused`, so face numbers are looked up before it changes.
    std::vector<FaceId> meshFaces;
    meshFaces.reserve(m_structure->n_faces());
    for (std::size_t f = 0; f < m_triangles.size(); ++f) {
        if (!m_refused[f]) {
            meshFaces.push_back(faceId(f));
        }
    }
    std::vector<bool> seen(m_structure->n_halfedges(), false);
    for (std::size_t h = 0; h < seen.size(); ++h) {
        const HalfEdge start(static_cast<int>(h));
        const auto vertex = m_structure->from_vertex_handle(start);
        if (seen[h] || !crowded[static_cast<std::size_t>(vertex.idx())]) {
            continue;
        }
        FaceId highest{};
        bool open = false;
        HalfEdge at = start;
        do {
            seen[static_cast<std::size_t>(at.idx())] = true;
            const auto face = m_structure->face_handle(at);
            if (face.is_valid()) {
                const FaceId meshFace = meshFaces[static_cast<std::size_t>(face.idx())];
                open = open || refused[indexOf(meshFace)];
                highest = std::max(highest, meshFace);
            } else {
                open = true;
            }
            at = m_structure->ccw_rotated_halfedge_handle(at);
        } while (at != start);
        if (!open) {
            refused[indexOf(highest)] = true;
        }
    }
}

std::vector<bool> refusedAtOnce(std::span<const Triangle> triangles)
{
    std::vector<bool> refused(triangles.size(), false);
    for (std::size_t f = 0; f < triangles.size(); ++f) {
        refused[f] = f >= kMaxStructureFaces || repeatsVertex(triangles[f]);
    }
    return refused;
}

} // namespace

HalfEdges::HalfEdges()
    : m_structure(std::make_unique<Structure>())
{
}

HalfEdges::HalfEdges(std::span<const Triangle> triangles,
                     std::size_t vertexCount,
                     const Adjacency& adjacency)
{
    check(adjacency.faceCount() == triangles.size(), "adjacency of these triangles");
    std::vector<bool> refused = refusedAtOnce(triangles);
    {
        Builder builder(triangles, vertexCount, adjacency, refused);
        const std::vector<bool> crowded = builder.crowdedVertices();
        if (crowded.empty()) {
            m_structure = builder.take();
        } else {
            builder.openRings(crowded, refused);
        }
    }
    if (!m_structure) {
        m_structure = Builder(triangles, vertexCount, adjacency, refused).take();
    }
    for (std::size_t f = 0; f < refused.size(); ++f) {
        if (refused[f]) {
            m_refused.push_back(faceId(f));
        }
    }
}

HalfEdges::~HalfEdges() = default;
HalfEdges::HalfEdges(HalfEdges&&) noexcept = default;
HalfEdges& HalfEdges::operator=(HalfEdges&&) noexcept = default;

std::optional<int> HalfEdges::structureFace(FaceId face) const
{
    const auto at = std::lower_bound(m_refused.begin(), m_refused.end(), face);
    if (at != m_refused.end() && *at == face) {
        return std::nullopt;
    }
    return static_cast<int>(indexOf(face)) - static_cast<int>(at - m_refused.begin());
}

FaceId HalfEdges::meshFace(int structureFace) const
{
    check(structureFace >= 0 && static_cast<std::size_t>(structureFace) < m_structure->n_faces(),
          "face of the structure exists");
    // Refused face i leaves m_refused[i] - i kept faces before it.
    const auto number = static_cast<std::size_t>(structureFace);
    std::size_t low = 0;
    std::size_t high = m_refused.size();
    while (low < high) {
        const std::size_t middle = (low + high) / 2;
        if (indexOf(m_refused[middle]) - middle <= number) {
            low = middle + 1;
        } else {
            high = middle;
        }
    }
    return faceId(number + low);
}

std::size_t HalfEdges::memoryBytes() const
{
    return m_structure->n_vertices() * sizeof(Structure::Vertex) +
           m_structure->n_edges() * sizeof(Structure::Edge) +
           m_structure->n_faces() * sizeof(Structure::Face) + m_refused.capacity() * sizeof(FaceId);
}

} // namespace trixel
