// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/filter/line_walk.h"

#include <algorithm>
#include <limits>

namespace trixel {
namespace {

/// Barycentric coordinate that is 0 on each edge: v, w, u.
std::array<double, 3> heights(glm::dvec2 uv)
{
    return {uv.y, 1 - uv.x - uv.y, uv.x};
}

/// Where along an edge, from its start, a point on it lies: u, v, w.
double along(std::size_t edge, glm::dvec2 uv)
{
    const double t = edge == 0 ? uv.x : edge == 1 ? uv.y : 1 - uv.x - uv.y;
    return std::clamp(t, 0.0, 1.0);
}

glm::dvec2 pointOn(std::size_t edge, double t)
{
    return edge == 0 ? glm::dvec2(t, 0) : edge == 1 ? glm::dvec2(1 - t, t) : glm::dvec2(0, 1 - t);
}

} // namespace

void walkLine(const FilterSurface& surface,
              FaceId face,
              glm::dvec2 start,
              glm::dvec2 step,
              double reach,
              LineWalk& walk)
{
    constexpr std::size_t kNoEdge = 3;
    // A line along an edge stays in its face: what rounding moves it is below this.
    constexpr double kParallel = 1e-12;
    std::size_t entered = kNoEdge;
    double t = 0;
    walk.count = 0;
    while (true) {
        const auto height = heights(start);
        const std::array<double, 3> rate = {step.y, -step.x - step.y, step.x};
        double inside = reach - t;
        std::size_t left = kNoEdge;
        for (std::size_t edge = 0; edge < 3; ++edge) {
            if (edge == entered || !(rate[edge] * inside < -kParallel)) {
                continue;
            }
            const double crossing = std::max(height[edge], 0.0) / -rate[edge];
            if (crossing < inside) {
                inside = crossing;
                left = edge;
            }
        }
        const double end = left == kNoEdge ? reach : std::min(t + inside, reach);
        walk.segments[walk.count++] = {face, t, end, start, step};
        walk.end = end;
        if (left == kNoEdge || walk.count == kMostSegments) {
            return;
        }
        const FilterSurface::EdgeStep& across = surface.steps(face).edges[left];
        if (across.across == FilterSurface::EdgeStep::kBorder) {
            return;
        }
        const double s = along(left, start + inside * step);
        face = faceId(across.across >> 2U);
        entered = across.across & 3U;
        start = pointOn(entered, 1 - s);
        step = {step.x * across.turn[0] + step.y * across.turn[2],
                step.x * across.turn[1] + step.y * across.turn[3]};
        t = end;
    }
}

} // namespace trixel
