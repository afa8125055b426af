// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/atlas/unfolded_place.h"

#include "core/lattice/edge_transfer.h"

#include <algorithm>
#include <optional>

namespace trixel {

namespace {

/// The edge that a point lies farthest beyond, or nothing where it is inside.
std::optional<LocalEdge> edgeBeyond(glm::dvec2 uv)
{
    const double w = 1 - uv.x - uv.y;
    const double least = std::min({uv.x, uv.y, w});
    return least >= 0      ? std::nullopt
           : least == uv.y ? std::optional(LocalEdge::E0)
           : least == w    ? std::optional(LocalEdge::E1)
                           : std::optional(LocalEdge::E2);
}

} // namespace

SurfacePlace unfoldedPlace(const Adjacency& adjacency, FaceId face, glm::dvec2 uv)
{
    constexpr int kMostCrossings = 4;
    for (int k = 0; k < kMostCrossings; ++k) {
        const std::optional<LocalEdge> edge = edgeBeyond(uv);
        const auto next = edge ? adjacency.neighbour(face, *edge) : std::nullopt;
        if (!next) {
            break;
        }
        uv = acrossEdge(*edge, next->edge, uv);
        face = next->face;
    }
    return {face, uv};
}

} // namespace trixel
