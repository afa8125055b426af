// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/footprint/svd2.h"
#include "core/mapping/quad.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>

namespace trixel {

namespace {

double cross(glm::dvec2 a, glm::dvec2 b)
{
    return differenceOfProducts(a.x, b.y, a.y, b.x);
}

double largestComponent(glm::dvec2 v)
{
    return std::max(std::abs(v.x), std::abs(v.y));
}

/// P - P00 = u b + v c + u v d, everything in units of the quad's size.
struct Bilinear
{
    glm::dvec2 b{0};
    glm::dvec2 c{0};
    glm::dvec2 d{0};

    glm::dvec2 at(glm::dvec2 uv) const { return uv.x * b + uv.y * c + uv.x * uv.y * d; }
    glm::dvec2 perU(double v) const { return b + v * d; }
    glm::dvec2 perV(double u) const { return c + u * d; }
    /// Area of the map's parallelogram at a point; linear in u and in v.
    double openness(glm::dvec2 uv) const { return cross(perU(uv.y), perV(uv.x)); }
};

/// Of the four corners the most open one's area, with its sign.
double mostOpenCorner(const Bilinear& map)
{
    double most = 0;
    for (const glm::dvec2 corner : {glm::dvec2(0, 0), {1, 0}, {1, 1}, {0, 1}}) {
        const double open = map.openness(corner);
        most = std::abs(open) > std::abs(most) ? open : most;
    }
    return most;
}

/// u from h = u b + v (c + u d), by the longer component of what it multiplies.
double solvedU(const Bilinear& map, glm::dvec2 h, double v)
{
    const glm::dvec2 along = map.perU(v);
    const glm::dvec2 rest = h - v * map.c;
    const double squared = glm::dot(along, along);
    return squared > 0 ? glm::dot(rest, along) / squared : 0;
}

glm::dvec2 newtonStep(const Bilinear& map, glm::dvec2 h, glm::dvec2 uv)
{
    const double open = map.openness(uv);
    if (!(std::abs(open) > 1e-9)) {
        return uv; // on the fold the step would be noise
    }
    const glm::dvec2 off = h - map.at(uv);
    return uv + glm::dvec2(cross(off, map.perV(uv.x)), cross(map.perU(uv.y), off)) / open;
}

double distanceFromSquare(glm::dvec2 uv)
{
    return std::max({-uv.x, uv.x - 1, -uv.y, uv.y - 1, 0.0});
}

/// Roots of a x² + b x + c, as many as are finite.
struct Roots
{
    std::array<double, 2> values{};
    int count = 0;

    void add(double root)
    {
        if (std::isfinite(root)) {
            values[static_cast<std::size_t>(count++)] = root;
        }
    }
};

Roots quadraticRoots(double a, double b, double c)
{
    const double discriminant = differenceOfProducts(b, b, 4 * a, c);
    Roots roots;
    // Rounding alone makes a double root miss by a little.
    constexpr double kRounding = 1e-14;
    if (discriminant < -kRounding * (b * b + std::abs(4 * a * c))) {
        return roots;
    }
    const double q = -0.5 * (b + std::copysign(std::sqrt(std::max(discriminant, 0.0)), b));
    if (q == 0) {
        roots.add(0); // b = c = 0
        return roots;
    }
    roots.add(c / q);
    roots.add(q / a); // infinite for a parallelogram, which has one root
    return roots;
}

} // namespace

std::optional<glm::dvec2> inverseBilinear(const Quad& quad, glm::dvec2 point)
{
    const glm::dvec2 b = quad.p10 - quad.p00;
    const glm::dvec2 c = quad.p01 - quad.p00;
    // As two differences of edges: P11 - P01 - P10 + P00 would add numbers of the position's size.
    const glm::dvec2 d = (quad.p11 - quad.p01) - b;
    const double size = std::max({largestComponent(b), largestComponent(c), largestComponent(d)});
    const glm::dvec2 h = (point - quad.p00) / size;
    if (!(size > 0) || !std::isfinite(size) || !std::isfinite(h.x) || !std::isfinite(h.y)) {
        return std::nullopt;
    }
    const Bilinear map{b / size, c / size, d / size};
    const double open = mostOpenCorner(map);
    constexpr double kFlattest = 1e-12;
    if (!(std::abs(open) > kFlattest)) {
        return std::nullopt;
    }
    // h × (b + v d) = v c × (b + v d), a quadratic in v whose slope at a root is minus the
    // openness.
    const Roots roots = quadraticRoots(
        cross(map.c, map.d), cross(map.c, map.b) - cross(h, map.d), -cross(h, map.b));
    std::optional<glm::dvec2> best;
    double bestDistance = 0;
    bool bestOpens = false;
    constexpr double kOnTheBorder = 1e-9;
    for (int k = 0; k < roots.count; ++k) {
        const double v = roots.values[static_cast<std::size_t>(k)];
        const glm::dvec2 uv = newtonStep(map, h, {solvedU(map, h, v), v});
        if (!std::isfinite(uv.x) || !std::isfinite(uv.y)) {
            continue;
        }
        const double distance = distanceFromSquare(uv);
        const bool inside = distance <= kOnTheBorder;
        const bool opens = map.openness(uv) * open > 0;
        const bool bestInside = best && bestDistance <= kOnTheBorder;
        if (!best || (inside != bestInside ? inside : opens && !bestOpens)) {
            best = uv;
            bestDistance = distance;
            bestOpens = opens;
        }
    }
    return best;
}

} // namespace trixel
