// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/filter/probe_walk.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/vec2.hpp>

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

/// Writes pieces down, one after the other.
struct PieceWriter
{
    Pieces& pieces;
    std::size_t side;

    /// \param first  number of the first of `count` probes
    void put(FaceId face, glm::dvec2 uv, glm::dvec2 step, int first, int count, double share)
    {
        const std::size_t at = pieces.count++;
        pieces.u[at] = uv.x;
        pieces.v[at] = uv.y;
        pieces.perU[at] = step.x;
        pieces.perV[at] = step.y;
        pieces.begin[at] = first;
        pieces.end[at] = first + count;
        pieces.share[at] = share;
        pieces.face[at] = static_cast<std::int64_t>(indexOf(face));
        pieces.id[at] = static_cast<std::int64_t>(side);
    }
};

/// Probes to one side, up to where the surface ends.
void placeSide(const FilterSurface& surface, const LineInFace& first, double end, PieceWriter out)
{
    const int whole = static_cast<int>(end);
    int next = 0;
    forFaces(surface, first, end, [&](const LineInFace& at) {
        const double leave = at.leave();
        const bool isLast = leave >= end;
        const glm::dvec2 exit = pointOn(at.edge, at.crossing());
        const glm::dvec2 step = (exit - at.entry) * (1 / std::max(leave - at.begin, 1e-300));
        const auto uvAt = [&](double t) { return at.entry + (t - at.begin) * step; };
        int beyond = next;
        while (beyond < whole && (isLast || beyond + 0.5 <= leave)) {
            ++beyond;
        }
        if (beyond > next) {
            out.put(at.face, uvAt(next + 0.5), step, next, beyond - next, 1);
            next = beyond;
        }
        // A border within the last step leaves a part of it.
        const double part = end - whole;
        if (next == whole && part > 0 && (isLast || whole + part / 2 <= leave)) {
            out.put(at.face, uvAt(whole + part / 2), step, whole, 1, part);
            ++next;
        }
    });
}

} // namespace

void placeProbes(const FilterSurface& surface,
                 const ProbeLine& line,
                 std::size_t side,
                 Pieces& pieces)
{
    const std::size_t before = pieces.count;
    if (line.hasDirection()) {
        const double reach = line.perSide();
        for (const double way : {1.0, -1.0}) {
            const LineInFace start = firstFace(surface, line, way);
            const double end = forFaces(surface, start, reach, [](const LineInFace&) {});
            // So little of a step has no weight that could be told from none.
            constexpr double kNothing = 1e-6;
            if (end > kNothing) {
                placeSide(surface, start, end, {pieces, way > 0 ? side : side + 1});
            }
        }
    }
    if (pieces.count == before) { // no step lies on the surface
        PieceWriter{pieces, side}.put(line.face, line.centre, {}, 0, 1, 1);
    }
}

} // namespace trixel
