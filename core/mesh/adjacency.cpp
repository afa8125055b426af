// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/adjacency.h"

#include "core/base/check.h"
#include "core/base/parallel.h"

#include <algorithm>

namespace trixel {
namespace {

std::uint32_t packed(FaceId face, LocalEdge edge)
{
    return static_cast<std::uint32_t>(face) << 2U | static_cast<std::uint32_t>(edge);
}

FaceId faceOf(std::uint32_t place)
{
    return faceId(place >> 2U);
}

LocalEdge edgeOf(std::uint32_t place)
{
    return static_cast<LocalEdge>(place & 3U);
}

// One side of an edge, kept in the bucket of the edge's lower vertex.
struct Side
{
    std::uint32_t vertexAndDirection = 0; // higher vertex << 1 | whether the side starts there
    std::uint32_t place = 0;              // face << 2 | edge

    bool operator<(const Side& b) const
    {
        return vertexAndDirection != b.vertexAndDirection
                   ? vertexAndDirection < b.vertexAndDirection
                   : place < b.place;
    }
};

// All sides of the mesh, grouped by lower vertex with a counting sort.
struct SideBuckets
{
    std::vector<std::uint32_t> begins; // of each vertex; one more at the end
    std::vector<Side> sides;
};

std::size_t vertexLimit(std::span<const Triangle> triangles)
{
    std::uint32_t highest = 0;
    for (const Triangle& t : triangles) {
        highest = std::max({highest, t[0], t[1], t[2]});
    }
    return std::size_t{highest} + 1;
}

SideBuckets bucketSides(std::span<const Triangle> triangles)
{
    SideBuckets buckets;
    buckets.begins.assign(vertexLimit(triangles) + 1, 0);
    for (const Triangle& t : triangles) {
        if (!repeatsVertex(t)) {
            for (std::size_t e = 0; e < 3; ++e) {
                ++buckets.begins[std::min(t[e], t[(e + 1) % 3])];
            }
        }
    }
    std::uint32_t end = 0;
    for (std::uint32_t& begin : buckets.begins) {
        end += begin;
        begin = end; // lowered to the true begin while the sides are put in place
    }
    buckets.sides.resize(end);
    for (std::size_t f = triangles.size(); f-- > 0;) {
        const Triangle& t = triangles[f];
        if (repeatsVertex(t)) {
            continue;
        }
        for (std::size_t e = 3; e-- > 0;) {
            const std::uint32_t from = t[e];
            const std::uint32_t to = t[(e + 1) % 3];
            const std::uint32_t direction = from > to ? 1 : 0;
            buckets.sides[--buckets.begins[std::min(from, to)]] = {
                std::max(from, to) << 1U | direction, packed(faceId(f), static_cast<LocalEdge>(e))};
        }
    }
    return buckets;
}

void sortSmall(std::span<Side> sides)
{
    if (sides.size() > 16) {
        std::sort(sides.begin(), sides.end());
        return;
    }
    for (std::size_t i = 1; i < sides.size(); ++i) {
        const Side side = sides[i];
        std::size_t at = i;
        for (; at > 0 && side < sides[at - 1]; --at) {
            sides[at] = sides[at - 1];
        }
        sides[at] = side;
    }
}

// Connects the edges of one bucket that exactly two faces share in opposite directions.
void joinSides(std::span<Side> sides, Adjacency& adjacency)
{
    sortSmall(sides);
    for (std::size_t i = 0; i < sides.size();) {
        std::size_t next = i + 1;
        while (next < sides.size() &&
               (sides[next].vertexAndDirection ^ sides[i].vertexAndDirection) < 2) {
            ++next;
        }
        if (next - i == 2 && sides[i].vertexAndDirection != sides[i + 1].vertexAndDirection) {
            adjacency.connect(faceOf(sides[i].place),
                              edgeOf(sides[i].place),
                              faceOf(sides[i + 1].place),
                              edgeOf(sides[i + 1].place));
        }
        i = next;
    }
}

} // namespace

Adjacency::Adjacency(std::size_t faceCount)
    : m_neighbours(3 * faceCount, kBorder)
{
    check(faceCount < std::size_t{1} << 30U, "fewer than 2^30 faces");
}

void Adjacency::connect(FaceId a, LocalEdge edgeOfA, FaceId b, LocalEdge edgeOfB)
{
    check(indexOf(a) < faceCount() && indexOf(b) < faceCount(), "face exists");
    m_neighbours[3 * indexOf(a) + indexOf(edgeOfA)] = packed(b, edgeOfB);
    m_neighbours[3 * indexOf(b) + indexOf(edgeOfB)] = packed(a, edgeOfA);
}

Adjacency buildAdjacency(std::span<const Triangle> triangles)
{
    Adjacency adjacency(triangles.size());
    SideBuckets buckets = bucketSides(triangles);
    // Every edge lies in one bucket, so buckets can be joined side by side.
    const auto joinBuckets = [&](std::size_t begin, std::size_t end) {
        for (std::size_t vertex = begin; vertex < end; ++vertex) {
            Side* const sides = buckets.sides.data();
            joinSides({sides + buckets.begins[vertex], sides + buckets.begins[vertex + 1]},
                      adjacency);
        }
    };
    parallelFor(buckets.begins.size() - 1, 1U << 16U, Threads::all(), joinBuckets);
    return adjacency;
}

} // namespace trixel
