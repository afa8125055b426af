// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/filter/surface_walk.h"

#include "core/filter/query_ellipse.h"

#include <algorithm>
#include <array>

namespace trixel {
namespace {

/// Barycentric heights above E0, E1, E2: v, w, u.
std::array<double, 3> heights(glm::dvec2 uv)
{
    return {uv.y, 1.0 - uv.x - uv.y, uv.x};
}

/// Where a segment leaves its face.
struct Exit
{
    LocalEdge edge{};
    double t = 2; ///< along the segment; above 1 when it stays inside
};

/// \param entered  the edge that `from` lies on, which rounding must not make it leave by again
Exit exitOf(glm::dvec2 from, glm::dvec2 to, std::optional<LocalEdge> entered)
{
    const auto before = heights(from);
    const auto after = heights(to);
    Exit exit;
    for (const LocalEdge edge : kLocalEdges) {
        const double end = after[indexOf(edge)];
        if (end >= 0 || edge == entered) {
            continue;
        }
        const double start = std::max(before[indexOf(edge)], 0.0);
        const double t = start / (start - end);
        if (t < exit.t) {
            exit = {edge, t};
        }
    }
    return exit;
}

} // namespace

SurfaceWalk walkStraight(const FilterSurface& surface,
                         const SurfacePlace& from,
                         glm::dvec2 step,
                         const glm::dmat2& carried)
{
    SurfaceWalk walk{from, carried, false};
    glm::dvec2 target = from.uv + step;
    std::optional<LocalEdge> entered;
    for (int crossings = 0;; ++crossings) {
        const Exit exit = exitOf(walk.end.uv, target, entered);
        if (exit.t > 1) {
            walk.end.uv = broughtInside(target);
            return walk;
        }
        walk.end.uv = broughtInside(walk.end.uv + exit.t * (target - walk.end.uv));
        const auto crossing =
            crossings < kMostCrossings ? surface.crossing(walk.end.face, exit.edge) : std::nullopt;
        if (!crossing) {
            walk.stopped = true;
            return walk;
        }
        walk.end = {crossing->face, broughtInside(crossing->point(walk.end.uv))};
        walk.carried = {crossing->vector(walk.carried[0]), crossing->vector(walk.carried[1])};
        target = crossing->point(target);
        entered = crossing->edge;
    }
}

} // namespace trixel
