// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/filter/probe_walk.h"

#include <algorithm>
#include <cmath>
#include <hwy/cache_control.h>

namespace trixel {
namespace {

/// Two functions, linear over each face's plane, that a line is made of: on which side of it a
/// point lies (positive: left), and how far along it.
struct LinePoint
{
    double side = 0;
    double along = 0;
};

/// Point t along an edge, from its start.
glm::dvec2 pointOn(std::uint32_t edge, double t)
{
    constexpr std::array<glm::dvec2, 3> kStarts = {
        glm::dvec2(0, 0), glm::dvec2(1, 0), glm::dvec2(0, 1)};
    constexpr std::array<glm::dvec2, 3> kEdges = {
        glm::dvec2(1, 0), glm::dvec2(-1, 1), glm::dvec2(0, -1)};
    return kStarts[edge] + t * kEdges[edge];
}

/// One way from the centre. Carries the line's two functions from face to face: those of a vertex
/// beyond an edge follow from the three of the face, with no division from one face to the next.
/// What it decides from face to face is as good as random, so it decides without branches.
class ProbeSide
{
public:
    ProbeSide() = default;
    /// \param line  its functions at the corners of the face
    ProbeSide(FaceId face, glm::dvec2 centre, const std::array<LinePoint, 3>& line, int last)
        : m_face(face)
        , m_entry(centre)
        , m_points(line)
        , m_last(last)
        , m_lastPlace(last - 0.5)
        , m_end(last)
    {
        // Counter-clockwise, the boundary goes from right to left of the line where the line
        // leaves.
        std::array<bool, 3> left = {line[0].side > 0, line[1].side > 0, line[2].side > 0};
        if (left[0] == left[1] && left[1] == left[2]) {
            // The centre is on the boundary and rounding has the line pass outside.
            const auto nearest = std::ranges::min_element(
                line, {}, [](const LinePoint& p) { return std::abs(p.side); });
            const auto at = static_cast<std::size_t>(nearest - line.begin());
            left[at] = !left[at];
        }
        while (left[m_edge] || !left[(m_edge + 1) % 3]) {
            ++m_edge;
        }
        m_right = m_edge;
        m_left = (m_edge + 1) % 3;
        m_far = (m_edge + 2) % 3;
    }

    bool isDone() const { return m_done; }
    /// Where the surface ended, or the last probe's step where it did not end before.
    double end() const { return m_end; }

    /// Goes on to where the surface was found to end, with a part of a step there, from the centre.
    void cutAt(double end)
    {
        m_last = std::min(m_last, static_cast<int>(std::ceil(end)));
        m_lastPlace = (m_last - 1 + end) / 2;
        m_done = m_last == 0;
    }

    /// Places the probes in this face and goes on to the next, up to `reach`.
    void advance(const FilterScene& scene, double reach, ProbeList& list)
    {
        const LinePoint& right = m_points[m_right];
        const LinePoint& left = m_points[m_left];
        // A line along the edge leaves anywhere on it.
        const double between = right.side - left.side;
        const double s = between < 0 ? std::clamp(right.side / between, 0.0, 1.0) : 0.5;
        const double leave = std::max(right.along + s * (left.along - right.along), m_begin);
        place(scene, leave, pointOn(m_edge, s), reach, list);
        if (leave >= reach) {
            m_done = true;
            return;
        }
        const FilterSurface::FaceSteps& steps = scene.surface().steps(m_face);
        const std::uint32_t across = steps.across[m_edge];
        if (across == FilterSurface::FaceSteps::kBorder || ++m_segments == kMostSegments) {
            m_end = leave;
            m_done = true;
            return;
        }
        const auto [x, y] = steps.beyond[m_edge];
        LinePoint& far = m_points[m_far];
        far = {right.side + x * (left.side - right.side) + y * (far.side - right.side),
               right.along + x * (left.along - right.along) + y * (far.along - right.along)};
        // The face beyond goes left, right, beyond around: the line leaves between the point beyond
        // and whichever lies on its other side.
        const bool isLeft = far.side > 0;
        const std::uint32_t entered = across & 3U;
        const std::uint32_t turned = entered + (isLeft ? 1U : 2U);
        m_edge = turned - (turned >= 3 ? 3U : 0U);
        const std::uint32_t beyond = m_far;
        m_far = isLeft ? m_left : m_right;
        m_left = isLeft ? beyond : m_left;
        m_right = isLeft ? m_right : beyond;
        m_face = faceId(across >> 2U);
        m_entry = pointOn(entered, 1 - s);
        m_begin = leave;
        hwy::Prefetch(&scene.surface().steps(m_face));
    }

private:
    /// Probes up to `leave`, where the line is at `exit`.
    void
    place(const FilterScene& scene, double leave, glm::dvec2 exit, double reach, ProbeList& list)
    {
        const ConformingPyramid::Finest finest = scene.pyramid().finest(m_face, Level(list.fine));
        const glm::dvec2 step = (exit - m_entry) * (1 / std::max(leave - m_begin, 1e-300));
        const auto put = [&](int k, std::size_t at) {
            // A border within the last step leaves a part of it.
            const double part = std::min(reach - k, 1.0);
            const double t = k + part / 2;
            list.put(at, finest, m_face, m_entry + (t - m_begin) * step, k + 0.5, part);
        };
        // Most faces have none or one or two: these are put down in any case, then counted.
        const double middle = std::min(leave, double{kMostProbes * 64}) + 0.5;
        const int whole = std::clamp(static_cast<int>(middle), m_next, m_last);
        const int end = leave >= reach || m_lastPlace < leave ? m_last : whole;
        put(m_next, list.count);
        put(m_next + 1, list.count + 1);
        for (int k = m_next + 2; k < end; ++k) {
            put(k, list.count + static_cast<std::size_t>(k - m_next));
        }
        list.count += static_cast<std::size_t>(end - m_next);
        check(list.count + 2 < ProbeList::kRoom, "no more probes than there is room for");
        m_next = end;
    }

    FaceId m_face{};
    glm::dvec2 m_entry{0};               // where the line entered the face, or the centre
    double m_begin = 0;                  // and how far along that is
    std::array<LinePoint, 3> m_points{}; // of the face's corners; which is which:
    std::uint32_t m_right = 0, m_left = 0, m_far = 0; // of the edge to leave by, and opposite
    std::uint32_t m_edge = 0;
    int m_next = 0;         // probe
    int m_last = 0;         // number of probes
    double m_lastPlace = 0; // of the last
    int m_segments = 0;
    double m_end = 0;
    bool m_done = false;
};

} // namespace

namespace {

/// Both ways of one line.
struct LineWalk
{
    FaceId face{};
    glm::dvec2 centre{0};
    ProbeList* list = nullptr;
    double reach = 0;
    std::array<ProbeSide, 2> fresh; ///< at the centre
    std::array<ProbeSide, 2> sides;

    void putCentre(const FilterScene& scene) const
    {
        list->put(0, scene.pyramid().finest(face, Level(list->fine)), face, centre, 0.5, 1);
        list->count = 1;
    }
};

/// Nothing to walk where all probes lie at the centre: then the list is done.
bool begin(const FilterScene& scene, const ProbeLine& from, ProbeList& list, LineWalk& line)
{
    const glm::dvec2 centre = from.centre;
    const glm::dvec2 step = from.step;
    list.count = 0;
    line.face = from.face;
    line.centre = centre;
    line.list = &list;
    const double squared = step.x * step.x + step.y * step.y;
    if (!(squared > 1e-30)) {
        line.putCentre(scene);
        return false;
    }
    const double perSquared = 1 / squared;
    const auto at = [&](double u, double v) {
        const double x = u - centre.x;
        const double y = v - centre.y;
        return LinePoint{step.x * y - step.y * x, (step.x * x + step.y * y) * perSquared};
    };
    std::array<LinePoint, 3> corners = {at(0, 0), at(1, 0), at(0, 1)};
    const int perSide = from.perSide();
    line.reach = perSide;
    line.fresh[0] = ProbeSide(from.face, centre, corners, perSide);
    for (LinePoint& point : corners) {
        point = {-point.side, -point.along};
    }
    line.fresh[1] = ProbeSide(from.face, centre, corners, perSide);
    line.sides = line.fresh;
    return true;
}

/// A border decides where the last probe before it lies: walks again to where the surface ended.
void placeWithinBorders(const FilterScene& scene, LineWalk& line)
{
    line.list->count = 0;
    for (std::size_t s = 0; s < 2; ++s) {
        ProbeSide side = line.fresh[s];
        // So little of a step has no weight that could be told from none.
        constexpr double kNothing = 1e-6;
        const double end = line.sides[s].end();
        const double cut = end > kNothing ? std::min(end, line.reach) : 0;
        side.cutAt(cut);
        while (!side.isDone()) {
            side.advance(scene, cut, *line.list);
        }
    }
}

} // namespace

void placeProbes(const FilterScene& scene,
                 std::span<const ProbeLine> from,
                 std::span<ProbeList* const> lists)
{
    check(from.size() <= kWalkedTogether && lists.size() == from.size(), "a list a line");
    std::array<LineWalk, kWalkedTogether> lines;
    std::size_t count = 0;
    for (std::size_t k = 0; k < from.size(); ++k) {
        count += begin(scene, from[k], *lists[k], lines[count]) ? 1 : 0;
    }
    std::array<std::pair<ProbeSide*, LineWalk*>, 2 * kWalkedTogether> active;
    std::size_t left = 0;
    for (std::size_t k = 0; k < count; ++k) {
        for (ProbeSide& side : lines[k].sides) {
            active[left++] = {&side, &lines[k]};
        }
    }
    while (left > 0) {
        for (std::size_t k = 0; k < left;) {
            const auto& [side, line] = active[k];
            side->advance(scene, line->reach, *line->list);
            if (side->isDone()) {
                active[k] = active[--left];
            } else {
                ++k;
            }
        }
    }
    for (std::size_t k = 0; k < count; ++k) {
        const auto& [ahead, back] = lines[k].sides;
        if (ahead.end() < lines[k].reach || back.end() < lines[k].reach) {
            placeWithinBorders(scene, lines[k]);
        }
        if (lines[k].list->count == 0) { // no step lies on the surface
            lines[k].putCentre(scene);
        }
    }
}

} // namespace trixel
