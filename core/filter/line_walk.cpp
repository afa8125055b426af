// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/filter/line_walk.h"

#include <algorithm>
#include <limits>

namespace trixel {
namespace {

/// Barycentric coordinate that is 0 on each edge: v, w, u.
std::array<float, 3> heights(glm::vec2 uv)
{
    return {uv.y, 1 - uv.x - uv.y, uv.x};
}

/// Where along an edge, from its start, a point on it lies: u, v, w.
float along(std::size_t edge, glm::vec2 uv)
{
    const float t = edge == 0 ? uv.x : edge == 1 ? uv.y : 1 - uv.x - uv.y;
    return std::clamp(t, 0.0F, 1.0F);
}

glm::vec2 pointOn(std::size_t edge, float t)
{
    return edge == 0 ? glm::vec2(t, 0) : edge == 1 ? glm::vec2(1 - t, t) : glm::vec2(0, 1 - t);
}

} // namespace

void walkLine(const FilterSurface& surface,
              FaceId face,
              glm::vec2 start,
              glm::vec2 step,
              float reach,
              LineWalk& walk)
{
    constexpr std::size_t kNoEdge = 3;
    // A line along an edge stays in its face: what rounding moves it is below this.
    constexpr float kParallel = 2.5e-7F;
    std::size_t entered = kNoEdge;
    float t = 0;
    walk.count = 0;
    while (true) {
        const auto height = heights(start);
        const std::array<float, 3> rate = {step.y, -step.x - step.y, step.x};
        float inside = reach - t;
        std::size_t left = kNoEdge;
        for (std::size_t edge = 0; edge < 3; ++edge) {
            if (edge == entered || !(rate[edge] * inside < -kParallel)) {
                continue;
            }
            const float crossing = std::max(height[edge], 0.0F) / -rate[edge];
            if (crossing < inside) {
                inside = crossing;
                left = edge;
            }
        }
        const float end = left == kNoEdge ? reach : std::min(t + inside, reach);
        walk.segments[walk.count++] = {face, t, end, start, step};
        walk.end = end;
        if (left == kNoEdge || walk.count == kMostSegments) {
            return;
        }
        const FilterSurface::EdgeStep& across = surface.steps(face).edges[left];
        if (across.across == FilterSurface::EdgeStep::kBorder) {
            return;
        }
        const float s = along(left, start + inside * step);
        face = faceId(across.across >> 2U);
        entered = across.across & 3U;
        start = pointOn(entered, 1 - s);
        step = {step.x * across.turn[0] + step.y * across.turn[2],
                step.x * across.turn[1] + step.y * across.turn[3]};
        t = end;
    }
}

} // namespace trixel
