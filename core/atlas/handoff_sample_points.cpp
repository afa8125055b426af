// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/atlas/handoff_sample_points.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>

namespace trixel {

HandOffSample cornerSample(std::uint8_t corner, int intervals)
{
    return corner == 0   ? HandOffSample{0, 0}
           : corner == 1 ? HandOffSample{intervals, 0}
                         : HandOffSample{0, intervals};
}

HandOffSample edgeSample(LocalEdge edge, int k, int intervals)
{
    switch (edge) {
    case LocalEdge::E0:
        return {k, 0};
    case LocalEdge::E1:
        return {intervals - k, k};
    case LocalEdge::E2:
        break;
    }
    return {0, intervals - k};
}

std::uint64_t sampleCount(int intervals)
{
    const auto n = static_cast<std::uint64_t>(intervals);
    return (n + 1) * (n + 2) / 2;
}

HandOffSample sampleOfNumber(std::uint64_t number, int intervals)
{
    check(number < sampleCount(intervals), "a sample of the face");
    const auto before = [&](int j) { // row j
        const auto row = static_cast<std::uint64_t>(j);
        return row * static_cast<std::uint64_t>(intervals + 1) - (row * row - row) / 2;
    };
    int low = 0;
    int high = intervals;
    while (low < high) {
        const int middle = (low + high + 1) / 2;
        if (before(middle) <= number) {
            low = middle;
        } else {
            high = middle - 1;
        }
    }
    return {static_cast<int>(number - before(low)), low};
}

HandOffSample nearestSample(glm::dvec2 uv, int intervals)
{
    const auto whole = [intervals](double value) {
        return std::clamp(static_cast<int>(std::lround(value * intervals)), 0, intervals);
    };
    const int i = whole(uv.x);
    const int j = whole(uv.y);
    const int beyond = std::max(0, i + j - intervals);
    // Back over the diagonal at a right angle to it.
    const int less = std::min(i, (beyond + 1) / 2);
    return {i - less, j - std::min(j, beyond - less)};
}

std::optional<EdgeNeighbour> HandOffOwners::edgeOwner(FaceId face, LocalEdge edge) const
{
    const auto other = m_surface.adjacency().neighbour(face, edge);
    if (!other) {
        return std::nullopt;
    }
    const auto rank = [this](FaceId of, LocalEdge at) {
        return std::tuple(m_layout.tile(of).intervals(), indexOf(of), indexOf(at));
    };
    return rank(other->face, other->edge) < rank(face, edge) ? other : std::nullopt;
}

Corner HandOffOwners::vertexOwner(Corner corner) const
{
    const VertexRings& rings = m_surface.rings();
    return std::ranges::min(rings.corners(rings.ring(corner)), {}, [](const Corner& of) {
        return std::pair(indexOf(of.face), of.index);
    });
}

bool HandOffOwners::Border::owns(HandOffSample sample, int intervals) const
{
    const int k = intervals - sample.i - sample.j;
    if (sample.i == intervals || sample.j == intervals || k == intervals) {
        return corners[k == intervals ? 0 : sample.i == intervals ? 1 : 2];
    }
    return sample.j == 0 ? edges[0] : k == 0 ? edges[1] : sample.i == 0 ? edges[2] : true;
}

HandOffOwners::Border HandOffOwners::border(FaceId face) const
{
    Border border;
    for (std::uint8_t k = 0; k < 3; ++k) {
        border.corners[k] = vertexOwner({face, k}) == Corner{face, k};
        border.edges[k] = !edgeOwner(face, kLocalEdges[k]);
    }
    return border;
}

} // namespace trixel
