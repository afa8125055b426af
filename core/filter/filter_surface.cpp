// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/filter/filter_surface.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <utility>

namespace trixel {
namespace {

glm::dvec2 cornerOf(const FaceShape& shape, std::size_t index)
{
    return index == 0 ? glm::dvec2(0) : index == 1 ? shape.e1 : shape.e2;
}

double edgeLength(const FaceShape& shape, std::size_t edge)
{
    return glm::length(cornerOf(shape, (edge + 1) % 3) - cornerOf(shape, edge));
}

} // namespace

FilterSurface FilterSurface::fromMesh(const TriangleMesh& mesh, Adjacency adjacency)
{
    check(mesh.faceCount() == adjacency.faceCount(), "adjacency of this mesh");
    FilterSurface surface;
    surface.m_rings = VertexRings(adjacency);
    surface.m_adjacency = std::move(adjacency);
    surface.m_shapes.reserve(mesh.faceCount());
    for (std::size_t f = 0; f < mesh.faceCount(); ++f) {
        surface.m_shapes.push_back(faceShapeOf(mesh.corners(faceId(f))));
    }
    surface.measureLengths();
    surface.layCrossings();
    surface.layLaneSteps();
    return surface;
}

FilterSurface FilterSurface::equilateral(Adjacency adjacency)
{
    FilterSurface surface;
    surface.m_rings = VertexRings(adjacency);
    surface.m_shapes.assign(adjacency.faceCount(), FaceShape{});
    surface.m_adjacency = std::move(adjacency);
    surface.measureLengths();
    surface.layCrossings();
    surface.layLaneSteps();
    return surface;
}

std::optional<FilterSurface::Crossing> FilterSurface::crossing(FaceId face, LocalEdge edge) const
{
    const auto across = m_adjacency.neighbour(face, edge);
    if (!across) {
        return std::nullopt;
    }
    const FaceShape& own = shape(face);
    const FaceShape& other = shape(across->face);
    // The neighbour runs along the edge the other way: its start is our end. Both edges are equally
    // long but for rounding and for faces whose shape was replaced; the ratio keeps (u,v) of the
    // edge on the edge in any case.
    const std::size_t start = indexOf(edge);
    const glm::dvec2 ownEnd = cornerOf(own, (start + 1) % 3);
    const glm::dvec2 ownAlong = cornerOf(own, start) - ownEnd;
    const std::size_t otherStart = indexOf(across->edge);
    const glm::dvec2 otherBegin = cornerOf(other, otherStart);
    const glm::dvec2 otherAlong = cornerOf(other, (otherStart + 1) % 3) - otherBegin;
    const double squared = glm::dot(ownAlong, ownAlong);
    // The similarity that takes ownAlong to otherAlong, as a complex factor.
    const glm::dvec2 turn((otherAlong.x * ownAlong.x + otherAlong.y * ownAlong.y) / squared,
                          (otherAlong.y * ownAlong.x - otherAlong.x * ownAlong.y) / squared);
    const auto turned = [&](glm::dvec2 p) {
        return glm::dvec2(turn.x * p.x - turn.y * p.y, turn.y * p.x + turn.x * p.y);
    };
    Crossing crossing{across->face, across->edge, {}, {}, {}};
    crossing.origin = other.toUv(otherBegin + turned(-ownEnd));
    crossing.perU = other.toUv(turned(own.e1));
    crossing.perV = other.toUv(turned(own.e2));
    return crossing;
}

double FilterSurface::log2Length(FaceId face, glm::dvec2 uv) const
{
    return (1 - uv.x - uv.y) * log2Length(face, 0) + uv.x * log2Length(face, 1) +
           uv.y * log2Length(face, 2);
}

void FilterSurface::layCrossings()
{
    constexpr std::array<glm::dvec2, 3> kCorners = {
        glm::dvec2(0, 0), glm::dvec2(1, 0), glm::dvec2(0, 1)};
    m_steps.resize(faceCount());
    for (std::size_t f = 0; f < faceCount(); ++f) {
        for (const LocalEdge edge : kLocalEdges) {
            const auto across = m_adjacency.neighbour(faceId(f), edge);
            if (!across) {
                continue;
            }
            const std::size_t e = indexOf(edge);
            const auto back = crossing(across->face, across->edge);
            const glm::dvec2 uv = back->point(kCorners[(indexOf(across->edge) + 2) % 3]);
            const std::array<double, 3> weights = {1 - uv.x - uv.y, uv.x, uv.y};
            m_steps[f].beyond[e] = {weights[(e + 1) % 3], weights[(e + 2) % 3]};
            m_steps[f].across[e] =
                static_cast<std::uint32_t>(indexOf(across->face) << 2U | indexOf(across->edge));
        }
    }
}

void FilterSurface::layLaneSteps()
{
    m_laneSteps.resize(faceCount());
    for (std::size_t f = 0; f < faceCount(); ++f) {
        m_laneSteps[f].apex = m_shapes[f].e2 / m_shapes[f].e1.x;
        m_laneSteps[f].across = m_steps[f].across;
    }
    measureClearance();
}

void FilterSurface::measureLengths()
{
    m_log2Lengths.assign(m_rings.ringCount(), 0.0);
    for (std::size_t r = 0; r < m_rings.ringCount(); ++r) {
        const auto corners = m_rings.corners(static_cast<RingId>(r));
        double sum = 0;
        int count = 0;
        // Each corner brings the edge it starts; an open ring lacks the one at its far border.
        for (const Corner& corner : corners) {
            sum += std::log2(edgeLength(shape(corner.face), corner.index));
            ++count;
        }
        if (!m_rings.isClosed(static_cast<RingId>(r))) {
            const Corner& last = corners.back();
            sum += std::log2(edgeLength(shape(last.face), (last.index + 2U) % 3));
            ++count;
        }
        m_log2Lengths[r] = sum / count;
    }
}

} // namespace trixel
