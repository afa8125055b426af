// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/filter/probe_walk.h"

#include <algorithm>
#include <cmath>

namespace trixel {
namespace {

/// Point t along an edge, from its start.
glm::dvec2 pointOn(std::size_t edge, double t)
{
    constexpr std::array<glm::dvec2, 3> kStarts = {
        glm::dvec2(0, 0), glm::dvec2(1, 0), glm::dvec2(0, 1)};
    constexpr std::array<glm::dvec2, 3> kEdges = {
        glm::dvec2(1, 0), glm::dvec2(-1, 1), glm::dvec2(0, -1)};
    return kStarts[edge] + t * kEdges[edge];
}

/// Where a line is in one face. Points of the plane are seen from the line's centre: x steps along
/// the line, y as many to its left.
struct LineInFace
{
    FaceId face{};
    glm::dvec2 entry{0};  ///< in (u,v)
    double begin = 0;     ///< how far along that is
    std::size_t edge = 0; ///< to leave by, which runs from the right of the line to its left
    glm::dvec2 right{0};
    glm::dvec2 left{0};

    /// How far along the edge, from its start, the line crosses it.
    double crossing() const
    {
        const double between = left.y - right.y;
        // A line along the edge leaves anywhere on it.
        return between > 0 ? std::clamp(-right.y / between, 0.0, 1.0) : 0.5;
    }
    double leave() const { return std::max(right.x + crossing() * (left.x - right.x), begin); }
};

/// The face of the centre, on the way along the line's step or against it.
LineInFace firstFace(const FilterSurface& surface, const ProbeLine& line, double way)
{
    const glm::dvec2 apex = surface.laneSteps(line.face).apex;
    const glm::dvec2 uvStep = way * line.step;
    const glm::dvec2 step(uvStep.x + uvStep.y * apex.x, uvStep.y * apex.y);
    const double perSquare = 1 / (step.x * step.x + step.y * step.y);
    const auto seen = [&](double u, double v) {
        const glm::dvec2 uv(u - line.centre.x, v - line.centre.y);
        const glm::dvec2 off(uv.x + uv.y * apex.x, uv.y * apex.y);
        const double cross = apex.y * (uvStep.x * uv.y - uvStep.y * uv.x);
        return glm::dvec2((step.x * off.x + step.y * off.y) * perSquare, cross * perSquare);
    };
    const std::array<glm::dvec2, 3> corners = {seen(0, 0), seen(1, 0), seen(0, 1)};
    std::array<bool, 3> left = {corners[0].y > 0, corners[1].y > 0, corners[2].y > 0};
    if (left[0] == left[1] && left[1] == left[2]) {
        // The centre is on the boundary and rounding has the line pass outside.
        const auto nearest = std::ranges::min_element(
            corners, {}, [](const glm::dvec2& p) { return std::abs(p.y); });
        const auto at = static_cast<std::size_t>(nearest - corners.begin());
        left[at] = !left[at];
    }
    LineInFace first{line.face, line.centre, 0, 0, {}, {}};
    while (left[first.edge] || !left[(first.edge + 1) % 3]) {
        ++first.edge;
    }
    first.right = corners[first.edge];
    first.left = corners[(first.edge + 1) % 3];
    return first;
}

/// The face beyond the edge that the line leaves by.
LineInFace nextFace(const FilterSurface& surface, const LineInFace& from, std::uint32_t across)
{
    LineInFace next = from;
    next.face = faceId(across >> 2U);
    const std::size_t entered = across & 3U;
    next.entry = pointOn(entered, 1 - from.crossing());
    next.begin = from.leave();
    // The edge runs from left to right here. The line leaves between the vertex beyond it and
    // whichever lies on the line's other side.
    const glm::dvec2 along = from.right - from.left;
    const glm::dvec2 z = surface.laneSteps(next.face).opposite(entered);
    const glm::dvec2 far =
        from.left + glm::dvec2(z.x * along.x - z.y * along.y, z.x * along.y + z.y * along.x);
    const bool isLeft = far.y > kSideRounding * (from.left.y - from.right.y);
    next.edge = (entered + (isLeft ? 1 : 2)) % 3;
    (isLeft ? next.left : next.right) = far;
    return next;
}

/// Calls visit(line in face) for every face up to `reach`; returns where the surface ends, or
/// `reach` where it does not end before.
template <class Visit>
double
forFaces(const FilterSurface& surface, const LineInFace& first, double reach, const Visit& visit)
{
    LineInFace at = first;
    for (int faces = 1;; ++faces) {
        visit(at);
        const double leave = at.leave();
        if (leave >= reach) {
            return reach;
        }
        const std::uint32_t across = surface.laneSteps(at.face).across[at.edge];
        if (across == FilterSurface::LaneSteps::kBorder || faces == kMostSegments) {
            return leave;
        }
        at = nextFace(surface, at, across);
    }
}

/// Writes probes down, one after the other.
struct ProbeWriter
{
    const FilterScene& scene;
    ProbeRange& range;
    ProbeArrays& probes;
    double perSupport;

    void put(FaceId face, glm::dvec2 uv, double place, double share)
    {
        const Level fine(range.fine);
        const ConformingPyramid::Finest finest = scene.pyramid().finest(face, fine);
        const std::size_t at = range.first + range.count;
        probes.u[at] = uv.x;
        probes.v[at] = uv.y;
        probes.scale[at] = finest.level.resolution();
        probes.values[at] = finest.values;
        probes.stride[at] = static_cast<std::int32_t>(finest.stride);
        probes.place[at] = static_cast<float>(place) * static_cast<float>(perSupport);
        probes.share[at] = static_cast<float>(share);
        probes.coarse[at] = finest.level < fine ? 0 : range.coarse;
        probes.face[at] = face;
        range.beyond |= finest.level < fine;
        ++range.count;
    }
};

/// Probes to one side, up to where the surface ends.
void placeSide(const FilterSurface& surface, const LineInFace& first, double end, ProbeWriter& out)
{
    const int last = static_cast<int>(std::ceil(end));
    int next = 0;
    forFaces(surface, first, end, [&](const LineInFace& at) {
        const double leave = at.leave();
        const glm::dvec2 exit = pointOn(at.edge, at.crossing());
        const glm::dvec2 step = (exit - at.entry) * (1 / std::max(leave - at.begin, 1e-300));
        for (; next < last; ++next) {
            // A border within the last step leaves a part of it.
            const double part = std::min(end - next, 1.0);
            const double t = next + part / 2;
            if (t > leave && leave < end) {
                break;
            }
            out.put(at.face, at.entry + (t - at.begin) * step, next + 0.5, part);
        }
    });
}

} // namespace

void placeProbes(const FilterScene& scene,
                 const ProbeLine& line,
                 ProbeRange& range,
                 ProbeArrays& probes)
{
    range.count = 0;
    ProbeWriter out{scene, range, probes, 1 / line.support};
    if (line.hasDirection()) {
        const double reach = line.perSide();
        for (const double way : {1.0, -1.0}) {
            const LineInFace start = firstFace(scene.surface(), line, way);
            const double end = forFaces(scene.surface(), start, reach, [](const LineInFace&) {});
            // So little of a step has no weight that could be told from none.
            constexpr double kNothing = 1e-6;
            if (end > kNothing) {
                placeSide(scene.surface(), start, end, out);
            }
        }
    }
    if (range.count == 0) { // no step lies on the surface
        out.put(line.face, line.centre, 0.5, 1);
    }
}

} // namespace trixel
