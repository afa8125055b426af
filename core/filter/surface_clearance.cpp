// SPDX-License-Identifier: GPL-3.0-or-later
#include <queue>

#include "core/filter/filter_surface.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <glm/geometric.hpp>
#include <limits>
#include <utility>

namespace trixel {
namespace {

constexpr double kNeverMet = std::numeric_limits<double>::infinity();

/// Lengths of edges 0, 1, 2.
std::array<double, 3> edgesOf(const FaceShape& shape)
{
    return {shape.e1.x, glm::length(shape.e2 - shape.e1), glm::length(shape.e2)};
}

/// Whether a line keeps its length over every edge of a face: it does not where a shape was
/// replaced.
bool keepsLengths(const FilterSurface& surface, FaceId face)
{
    const std::array<double, 3> own = edgesOf(surface.shape(face));
    return std::ranges::all_of(kLocalEdges, [&](LocalEdge edge) {
        const auto across = surface.adjacency().neighbour(face, edge);
        if (!across) {
            return true;
        }
        const double other = edgesOf(surface.shape(across->face))[indexOf(across->edge)];
        return std::abs(other - own[indexOf(edge)]) <= 1e-6 * other;
    });
}

double leastHeight(const FaceShape& shape)
{
    return shape.e1.x * shape.e2.y / std::ranges::max(edgesOf(shape));
}

} // namespace

// A function linear over each face, 0 on the border, that no face lets grow faster than 1 a unit:
// it is nowhere larger than the distance to the border. Its values at a face's vertices may differ
// by the face's least height, which makes them shortest paths.
void FilterSurface::measureClearance()
{
    std::vector<double> least(m_rings.ringCount(), kNeverMet);
    using Reached = std::pair<double, RingId>;
    std::priority_queue<Reached, std::vector<Reached>, std::greater<>> open;
    const auto reach = [&](RingId ring, double distance) {
        if (distance < least[indexOf(ring)]) {
            least[indexOf(ring)] = distance;
            open.emplace(distance, ring);
        }
    };
    const auto ringOf = [&](FaceId face, std::uint8_t corner) {
        return m_rings.ring({face, corner});
    };
    for (std::size_t f = 0; f < faceCount(); ++f) {
        if (!keepsLengths(*this, faceId(f))) {
            for (std::uint8_t corner = 0; corner < 3; ++corner) {
                reach(ringOf(faceId(f), corner), 0);
            }
        }
    }
    for (std::size_t r = 0; r < m_rings.ringCount(); ++r) {
        if (!m_rings.isClosed(static_cast<RingId>(r))) {
            reach(static_cast<RingId>(r), 0);
        }
    }
    while (!open.empty()) {
        const auto [distance, ring] = open.top();
        open.pop();
        if (distance > least[indexOf(ring)]) {
            continue;
        }
        for (const Corner& corner : m_rings.corners(ring)) {
            const double next = distance + leastHeight(shape(corner.face));
            reach(ringOf(corner.face, static_cast<std::uint8_t>((corner.index + 1) % 3)), next);
            reach(ringOf(corner.face, static_cast<std::uint8_t>((corner.index + 2) % 3)), next);
        }
    }
    for (std::size_t f = 0; f < faceCount(); ++f) {
        const FaceId face = faceId(f);
        const double distance = std::min({least[indexOf(ringOf(face, 0))],
                                          least[indexOf(ringOf(face, 1))],
                                          least[indexOf(ringOf(face, 2))]});
        // A little less than that, for rounding.
        m_laneSteps[f].clearance = static_cast<float>(0.999 * distance / m_shapes[f].e1.x);
    }
}

} // namespace trixel
