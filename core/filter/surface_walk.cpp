// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/filter/surface_walk.h"

#include "core/filter/query_ellipse.h"
#include "core/lattice/edge_transfer.h"

#include <algorithm>
#include <array>

namespace trixel {
namespace {

/// Barycentric heights above E0, E1, E2: v, w, u.
std::array<double, 3> heights(glm::dvec2 uv)
{
    return {uv.y, 1.0 - uv.x - uv.y, uv.x};
}

constexpr std::size_t kNoEdge = 3;

/// Where a segment leaves its face.
struct Exit
{
    std::size_t edge = kNoEdge; ///< kNoEdge when it stays inside
    double t = 1;               ///< along the segment
};

/// \param entered  the edge that `from` lies on, which rounding must not make it leave by again
Exit exitOf(glm::dvec2 from, glm::dvec2 to, std::size_t entered)
{
    const auto before = heights(from);
    const auto after = heights(to);
    Exit exit;
    for (std::size_t edge = 0; edge < 3; ++edge) {
        if (after[edge] >= 0 || edge == entered) {
            continue;
        }
        const double start = std::max(before[edge], 0.0);
        const double t = start / (start - after[edge]);
        if (t < exit.t || exit.edge == kNoEdge) {
            exit = {edge, t};
        }
    }
    return exit;
}

/// A vector of the face before, in (u,v) of the one across an edge.
glm::dvec2 turned(const FilterSurface::FaceSteps& steps, std::size_t edge, glm::dvec2 w)
{
    // Along the edge and towards the far vertex, on this side and on the other, where the edge
    // runs the other way.
    const std::array<double, 3> own = {-w.x - w.y, w.x, w.y};
    const auto [x, y] = steps.beyond[edge];
    const double towards = own[(edge + 2) % 3] / y;
    const double along = towards * (x - 1) - own[(edge + 1) % 3];
    const std::size_t entered = steps.across[edge] & 3U;
    std::array<double, 3> other{};
    other[entered] = -along - towards;
    other[(entered + 1) % 3] = along;
    other[(entered + 2) % 3] = towards;
    return {other[1], other[2]};
}

/// The point of the edge, seen from its other side: what is t along it is 1 - t there.
glm::dvec2 mirrored(glm::dvec2 uv, LocalEdge from, LocalEdge to)
{
    return fromEdge(to, {1 - std::clamp(toEdge(from, uv).t, 0.0, 1.0), 0});
}

} // namespace

SurfaceWalk walkStraight(const FilterSurface& surface,
                         const SurfacePlace& from,
                         glm::dvec2 step,
                         const glm::dmat2& carried)
{
    SurfaceWalk walk{from, carried, false};
    std::size_t entered = kNoEdge;
    for (int crossings = 0;; ++crossings) {
        const Exit exit = exitOf(walk.end.uv, walk.end.uv + step, entered);
        walk.end.uv = broughtInside(walk.end.uv + exit.t * step);
        if (exit.edge == kNoEdge) {
            return walk;
        }
        const FilterSurface::FaceSteps& steps = surface.steps(walk.end.face);
        const std::uint32_t across = steps.across[exit.edge];
        if (across == FilterSurface::FaceSteps::kBorder || crossings == kMostCrossings) {
            walk.stopped = true;
            return walk;
        }
        entered = across & 3U;
        walk.end = {faceId(across >> 2U),
                    mirrored(walk.end.uv,
                             static_cast<LocalEdge>(exit.edge),
                             static_cast<LocalEdge>(entered))};
        walk.carried = {turned(steps, exit.edge, walk.carried[0]),
                        turned(steps, exit.edge, walk.carried[1])};
        step = (1 - exit.t) * turned(steps, exit.edge, step);
    }
}

} // namespace trixel
