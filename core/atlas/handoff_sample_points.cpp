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

std::vector<HandOffSample> HandOffOwners::ownSamples(FaceId face) const
{
    const int n = m_layout.tile(face).intervals();
    std::vector<HandOffSample> samples;
    for (std::uint8_t k = 0; k < 3; ++k) {
        if (vertexOwner({face, k}) == Corner{face, k}) {
            samples.push_back(cornerSample(k, n));
        }
    }
    for (const LocalEdge edge : {LocalEdge::E0, LocalEdge::E1, LocalEdge::E2}) {
        for (int k = 1; k < n && !edgeOwner(face, edge); ++k) {
            samples.push_back(edgeSample(edge, k, n));
        }
    }
    for (int j = 1; j < n; ++j) {
        for (int i = 1; i + j < n; ++i) {
            samples.push_back({i, j});
        }
    }
    return samples;
}

} // namespace trixel
