// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/limit_patterns.h"

#include "core/base/check.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <map>
#include <opensubdiv/bfr/tessellation.h>
#include <utility>

namespace trixel {

namespace {

namespace Bfr = OpenSubdiv::Bfr;

using Corners = std::array<std::uint16_t, 3>;

/// Where the faces of a lattice are equilateral.
glm::dvec2 equilateral(glm::dvec2 uv)
{
    return {uv.x + 0.5 * uv.y, 0.8660254037844386 * uv.y};
}

/// Turns sides of the triangles at the border until no triangle's circle holds a point of its
/// neighbour (Lawson 1977). The library joins corners to the points within by long diagonals, which
/// bend the most; further within is a lattice.
class Flipper
{
public:
    Flipper(CutPattern& pattern, std::size_t borderPoints)
        : m_triangles(pattern.triangles)
    {
        for (const glm::dvec2 uv : pattern.points) {
            m_points.push_back(equilateral(uv));
        }
        for (std::size_t t = 0; t < m_triangles.size(); ++t) {
            if (std::ranges::any_of(m_triangles[t], [&](auto p) { return p < borderPoints; })) {
                m_atBorder.push_back(t);
                note(t);
            }
        }
    }

    void run()
    {
        for (bool turned = true; turned;) {
            turned = false;
            for (const std::size_t t : m_atBorder) {
                for (std::size_t k = 0; k < 3; ++k) {
                    turned = turn(t, k) || turned;
                }
            }
        }
    }

private:
    void note(std::size_t t)
    {
        for (std::size_t k = 0; k < 3; ++k) {
            m_triangleAt[{m_triangles[t][k], m_triangles[t][(k + 1) % 3]}] = t;
        }
    }

    /// Of the angle at c that looks at the side ab.
    double cotangent(std::uint16_t a, std::uint16_t b, std::uint16_t c) const
    {
        const glm::dvec2 p = m_points[a] - m_points[c];
        const glm::dvec2 q = m_points[b] - m_points[c];
        return glm::dot(p, q) / (p.x * q.y - p.y * q.x);
    }

    bool turn(std::size_t t, std::size_t k)
    {
        const std::uint16_t a = m_triangles[t][k];
        const std::uint16_t b = m_triangles[t][(k + 1) % 3];
        const std::uint16_t c = m_triangles[t][(k + 2) % 3];
        const auto across = m_triangleAt.find({b, a});
        if (across == m_triangleAt.end()) {
            return false;
        }
        const std::size_t other = across->second;
        std::uint16_t d = 0;
        for (const std::uint16_t corner : m_triangles[other]) {
            d = corner != a && corner != b ? corner : d;
        }
        // The angles that look at the side come to more than a half turn.
        if (cotangent(a, b, c) + cotangent(b, a, d) > -1e-9) {
            return false;
        }
        m_triangleAt.erase({a, b});
        m_triangleAt.erase({b, a});
        m_triangles[t] = {c, a, d};
        m_triangles[other] = {d, b, c};
        note(t);
        note(other);
        return true;
    }

    std::vector<Corners>& m_triangles;
    std::vector<std::size_t> m_atBorder;
    std::vector<glm::dvec2> m_points;
    std::map<std::pair<std::uint16_t, std::uint16_t>, std::size_t> m_triangleAt; ///< by its side
};

CutPattern cut(const CutRates& rates)
{
    const std::array<int, 4> pieces = {
        rates.edges[0], rates.edges[1], rates.edges[2], rates.inside};
    const Bfr::Parameterization triangle(OpenSubdiv::Sdc::SCHEME_LOOP, 3);
    const Bfr::Tessellation made(triangle, 4, pieces.data());
    check(made.IsValid(), "every triangle can be cut");
    CutPattern pattern;
    pattern.points.resize(static_cast<std::size_t>(made.GetNumCoords()));
    made.GetCoords(&pattern.points.front().x);
    std::vector<int> corners(3 * static_cast<std::size_t>(made.GetNumFacets()));
    made.GetFacets(corners.data());
    pattern.triangles.resize(corners.size() / 3);
    for (std::size_t k = 0; k < corners.size(); ++k) {
        pattern.triangles[k / 3][k % 3] = static_cast<std::uint16_t>(corners[k]);
    }
    if (!made.IsUniform()) {
        Flipper(pattern, static_cast<std::size_t>(made.GetNumBoundaryCoords())).run();
    }
    return pattern;
}

} // namespace

const CutPattern& PatternCutter::pattern(const CutRates& rates)
{
    const std::uint32_t key = rates.edges[0] | static_cast<std::uint32_t>(rates.edges[1]) << 8U |
                              static_cast<std::uint32_t>(rates.edges[2]) << 16U |
                              static_cast<std::uint32_t>(rates.inside) << 24U;
    std::unique_ptr<CutPattern>& pattern = m_patterns[key];
    if (!pattern) {
        pattern = std::make_unique<CutPattern>(cut(rates));
    }
    return *pattern;
}

} // namespace trixel
