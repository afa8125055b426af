// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/ear_cutter.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <numeric>

namespace trixel {
namespace {

constexpr std::size_t kTestsPerCorner = 1000;

// Newell's method: twice the area of the polygon as seen along each axis.
glm::dvec3 areaVector(std::span<const glm::vec3> positions, std::span<const std::uint32_t> corners)
{
    const glm::dvec3 origin(positions[corners[0]]);
    glm::dvec3 area(0);
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const std::uint32_t next = corners[i + 1 < corners.size() ? i + 1 : 0];
        area += glm::cross(glm::dvec3(positions[corners[i]]) - origin,
                           glm::dvec3(positions[next]) - origin);
    }
    return area;
}

// The polygon seen along the axis it faces most, counter-clockwise, its longer side along x.
std::vector<glm::dvec2> flattened(std::span<const glm::vec3> positions,
                                  std::span<const std::uint32_t> corners)
{
    const glm::dvec3 area = areaVector(positions, corners);
    const glm::dvec3 size = glm::abs(area);
    const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    const int x = (axis + 1) % 3;
    const int y = (axis + 2) % 3;
    const double mirror = area[axis] < 0 ? -1.0 : 1.0;
    std::vector<glm::dvec2> points;
    points.reserve(corners.size());
    glm::dvec2 low(INFINITY);
    glm::dvec2 high(-INFINITY);
    for (const std::uint32_t corner : corners) {
        points.emplace_back(mirror * static_cast<double>(positions[corner][x]),
                            static_cast<double>(positions[corner][y]));
        low = glm::min(low, points.back());
        high = glm::max(high, points.back());
    }
    if (high.y - low.y > high.x - low.x) {
        for (glm::dvec2& point : points) {
            point = {point.y, -point.x};
        }
    }
    return points;
}

double turn(glm::dvec2 a, glm::dvec2 b, glm::dvec2 c)
{
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

// Ear cutting on a ring of corners. A corner that turns right ("reflex") can lie in the way of an
// ear; it may lose that property as ears fall, never gain it.
class Ring
{
public:
    explicit Ring(std::vector<glm::dvec2> points);

    bool isStrictlyConvex() const { return m_strictlyConvex; }
    std::size_t next(std::size_t corner) const { return m_next[corner]; }
    std::size_t previous(std::size_t corner) const { return m_previous[corner]; }

    double turnAt(std::size_t corner) const
    {
        return turn(m_points[m_previous[corner]], m_points[corner], m_points[m_next[corner]]);
    }

    // Whether no other corner lies in the triangle at `corner`. Counts its work in `tests`.
    bool isEar(std::size_t corner, std::size_t& tests) const;

    void remove(std::size_t corner)
    {
        m_next[m_previous[corner]] = m_next[corner];
        m_previous[m_next[corner]] = m_previous[corner];
        m_removed[corner] = true;
    }

private:
    std::vector<glm::dvec2> m_points;
    std::vector<std::size_t> m_next;
    std::vector<std::size_t> m_previous;
    std::vector<bool> m_removed;
    std::vector<std::size_t> m_reflex; // in ascending order of x
    bool m_strictlyConvex = true;
};

Ring::Ring(std::vector<glm::dvec2> points)
    : m_points(std::move(points))
    , m_next(m_points.size())
    , m_previous(m_points.size())
    , m_removed(m_points.size(), false)
{
    const std::size_t count = m_points.size();
    for (std::size_t i = 0; i < count; ++i) {
        m_next[i] = (i + 1) % count;
        m_previous[i] = (i + count - 1) % count;
    }
    for (std::size_t i = 0; i < count; ++i) {
        const double turned = turnAt(i);
        m_strictlyConvex = m_strictlyConvex && turned > 0;
        if (turned < 0) {
            m_reflex.push_back(i);
        }
    }
    std::sort(m_reflex.begin(), m_reflex.end(), [&](std::size_t a, std::size_t b) {
        return m_points[a].x < m_points[b].x;
    });
}

bool Ring::isEar(std::size_t corner, std::size_t& tests) const
{
    const glm::dvec2 a = m_points[m_previous[corner]];
    const glm::dvec2 b = m_points[corner];
    const glm::dvec2 c = m_points[m_next[corner]];
    ++tests;
    if (turn(a, b, c) <= 0) {
        return false;
    }
    const double right = std::max({a.x, b.x, c.x});
    auto at =
        std::lower_bound(m_reflex.begin(),
                         m_reflex.end(),
                         std::min({a.x, b.x, c.x}),
                         [&](std::size_t reflex, double x) { return m_points[reflex].x < x; });
    for (; at != m_reflex.end() && m_points[*at].x <= right; ++at) {
        ++tests;
        const glm::dvec2 p = m_points[*at];
        // A corner at the same place as one of the ear's (a bridge to a hole) is not in the way.
        if (!m_removed[*at] && p != a && p != b && p != c && turn(a, b, p) >= 0 &&
            turn(b, c, p) >= 0 && turn(c, a, p) >= 0) {
            return false;
        }
    }
    return true;
}

// The next corner from `start` on that can be cut off: an ear, or else one without area.
std::size_t findEar(const Ring& ring, std::size_t start, std::size_t left, std::size_t& tests)
{
    std::size_t flat = start;
    bool hasFlat = false;
    std::size_t corner = start;
    for (std::size_t i = 0; i < left; ++i, corner = ring.next(corner)) {
        if (ring.isEar(corner, tests)) {
            return corner;
        }
        if (!hasFlat && ring.turnAt(corner) == 0) {
            flat = corner;
            hasFlat = true;
        }
    }
    return flat;
}

} // namespace

void cutEars(std::span<const glm::vec3> positions,
             std::span<const std::uint32_t> corners,
             std::span<Triangle> triangles)
{
    Ring ring(flattened(positions, corners));
    const std::size_t limit = ring.isStrictlyConvex() ? 0 : kTestsPerCorner * corners.size();
    std::size_t tests = 0;
    std::size_t corner = 1; // cut off first: a fan of a convex polygon starts at its first corner
    for (std::size_t i = 0; i < triangles.size(); ++i) {
        if (tests < limit) {
            corner = findEar(ring, corner, corners.size() - i, tests);
        }
        const std::size_t before = ring.previous(corner);
        const std::size_t after = ring.next(corner);
        triangles[i] = {corners[before], corners[corner], corners[after]};
        ring.remove(corner);
        corner = after;
    }
}

} // namespace trixel
