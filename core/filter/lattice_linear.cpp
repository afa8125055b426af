// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/filter/level_blend.h"
#include "core/filter/methods.h"
#include "core/filter/query_filter.h"
#include "core/lattice/edge_transfer.h"

#include <cmath>

namespace trixel {
namespace {

/// Interpolates the texels of one level of one face so that it is continuous everywhere, edges and
/// corners of the face included:
///   f = (1 - 2 αq - αr) vertexMean(P) + (2 αr + αq) T + (αq - αr) T',
/// αp >= αq >= αr the barycentrics within texel T, T' its neighbour across PQ. It is the linear
/// interpolation between vertex P, the middle of edge PQ (mean of T and T') and the centroid.
///
/// Where the neighbouring face is coarser than this level, what that face has along the edge rules:
/// values on the edge are taken from its line of vertices and middles.
class HexlinFace
{
public:
    HexlinFace(const FilterScene& scene, FaceId face, Level level, int group)
        : m_scene(scene)
        , m_face(face)
        , m_level(level)
        , m_group(group)
    {
    }

    void add(glm::dvec2 uv, float weight, GroupValue& sum)
    {
        const std::uint32_t r = m_level.resolution();
        const TexelCoord coord = texelAt(m_level, uv);
        const int upper = coord.half == TexelHalf::Upper ? 1 : 0;
        const double x = std::clamp(uv.x * r - coord.i, 0.0, 1.0);
        const double y = std::clamp(uv.y * r - coord.j, 0.0, 1.0);
        const double u = upper != 0 ? 1 - x : x;
        const double v = upper != 0 ? 1 - y : y;
        // Corners of the texel: the right angle, along u, along v; edge k runs from corner k.
        const std::array<double, 3> alpha = {std::max(1 - u - v, 0.0), u, v};
        std::array<std::size_t, 3> order = {0, 1, 2};
        std::ranges::sort(order, [&](std::size_t a, std::size_t b) { return alpha[a] > alpha[b]; });
        const double q = alpha[order[1]];
        const double rest = alpha[order[2]];
        const std::size_t edge = order[0] + order[1] == 1 ? 0 : order[0] + order[1] == 3 ? 1 : 2;

        const int turn = upper != 0 ? -1 : 1;
        const std::array<int, 3> du = {0, turn, 0};
        const std::array<int, 3> dv = {0, 0, turn};
        const int i = coord.i + upper + du[order[0]];
        const int j = coord.j + upper + dv[order[0]];
        addScaled(vertex(i, j), weight * static_cast<float>(1 - 2 * q - rest), sum);
        const GroupValue own = texel(m_face, m_level, coord);
        // (q - r) T' = (q - r) (2 middle - T)
        addScaled(own, weight * static_cast<float>(3 * rest), sum);
        addScaled(middle(coord, edge, own), weight * static_cast<float>(2 * (q - rest)), sum);
    }

private:
    static void addScaled(const GroupValue& value, float weight, GroupValue& sum)
    {
        for (std::size_t c = 0; c < sum.size(); ++c) {
            sum[c] += weight * value[c];
        }
    }

    static GroupValue mixed(const GroupValue& a, const GroupValue& b, float t)
    {
        GroupValue value{};
        addScaled(a, 1 - t, value);
        addScaled(b, t, value);
        return value;
    }

    GroupValue texel(FaceId face, Level level, TexelCoord coord) const
    {
        const float* from =
            m_scene.mips().texels(face, level, m_group).texel(texelIndex(level, coord));
        GroupValue value;
        std::copy_n(from, kGroupChannels, value.begin());
        return value;
    }

    GroupValue stored(Level level, std::uint32_t i, std::uint32_t j) const
    {
        const LevelVertices vertices = m_scene.pyramid().vertices(m_face, level, m_group);
        GroupValue value;
        const float* from = vertices.values + vertices.stride * latticeVertex(level, i, j);
        std::copy_n(from, kGroupChannels, value.begin());
        return value;
    }

    /// Vertex k of an edge, from its start.
    GroupValue storedOnEdge(Level level, std::size_t edge, std::uint32_t k) const
    {
        const std::uint32_t r = level.resolution();
        return edge == 0   ? stored(level, k, 0)
               : edge == 1 ? stored(level, r - k, k)
                           : stored(level, 0, r - k);
    }

    /// Texel k along an edge, from its start.
    static TexelCoord borderTexel(Level level, std::size_t edge, std::uint32_t k)
    {
        const std::uint32_t last = level.resolution() - 1;
        const auto narrow = [](std::uint32_t n) { return static_cast<std::uint16_t>(n); };
        return edge == 0   ? TexelCoord{narrow(k), 0, TexelHalf::Lower}
               : edge == 1 ? TexelCoord{narrow(last - k), narrow(k), TexelHalf::Lower}
                           : TexelCoord{0, narrow(last - k), TexelHalf::Lower};
    }

    /// Mean of the two texels that meet at place k along an edge of the face; at a border the own.
    GroupValue middleOnEdge(Level level, std::size_t edge, std::uint32_t k) const
    {
        const GroupValue own = texel(m_face, level, borderTexel(level, edge, k));
        const auto across =
            m_scene.surface().adjacency().neighbour(m_face, static_cast<LocalEdge>(edge));
        if (!across) {
            return own;
        }
        const TexelCoord there =
            borderTexel(level, indexOf(across->edge), level.resolution() - 1 - k);
        return mixed(own, texel(across->face, level, there), 0.5F);
    }

    Level levelAcross(std::size_t edge) const
    {
        const auto across =
            m_scene.surface().adjacency().neighbour(m_face, static_cast<LocalEdge>(edge));
        return across ? std::min(m_level, m_scene.level(across->face)) : m_level;
    }

    /// Value `at` (in texels of the level) along an edge whose other side is at `base`.
    GroupValue onCoarserEdge(std::size_t edge, Level base, double at) const
    {
        const double there = std::ldexp(at, base.log2() - m_level.log2());
        const auto k = std::min(static_cast<std::uint32_t>(there), base.resolution() - 1);
        const double t = there - k;
        const GroupValue half = middleOnEdge(base, edge, k);
        return t <= 0.5
                   ? mixed(storedOnEdge(base, edge, k), half, static_cast<float>(2 * t))
                   : mixed(half, storedOnEdge(base, edge, k + 1), static_cast<float>(2 * t - 1));
    }

    GroupValue vertex(int i, int j) const
    {
        const auto at = static_cast<std::uint32_t>(i);
        const auto up = static_cast<std::uint32_t>(j);
        const std::uint32_t r = m_level.resolution();
        const std::array<bool, 3> on = {up == 0, at + up == r, at == 0};
        const std::array<std::uint32_t, 3> place = {at, up, r - up};
        for (std::size_t edge = 0; edge < 3; ++edge) {
            if (!on[edge] || place[edge] == 0 || place[edge] == r) {
                continue; // corners are the same in all faces as they are stored
            }
            const Level base = levelAcross(edge);
            return base < m_level ? onCoarserEdge(edge, base, place[edge])
                                  : stored(m_level, at, up);
        }
        return stored(m_level, at, up);
    }

    /// Middle of an edge of a texel.
    GroupValue middle(TexelCoord coord, std::size_t edge, const GroupValue& own) const
    {
        const std::uint32_t r = m_level.resolution();
        const bool lower = coord.half == TexelHalf::Lower;
        const std::array<bool, 3> border = {lower && coord.j == 0,
                                            lower && std::uint32_t{coord.i} + coord.j == r - 1,
                                            lower && coord.i == 0};
        if (border[edge]) {
            const std::array<std::uint32_t, 3> place = {coord.i, coord.j, r - 1U - coord.j};
            const Level base = levelAcross(edge);
            return base < m_level ? onCoarserEdge(edge, base, place[edge] + 0.5)
                                  : middleOnEdge(m_level, edge, place[edge]);
        }
        const int turn = lower ? 1 : -1;
        const std::array<int, 3> di = {0, 0, -turn};
        const std::array<int, 3> dj = {-turn, 0, 0};
        const TexelCoord other{static_cast<std::uint16_t>(coord.i + di[edge]),
                               static_cast<std::uint16_t>(coord.j + dj[edge]),
                               lower ? TexelHalf::Upper : TexelHalf::Lower};
        return mixed(own, texel(m_face, m_level, other), 0.5F);
    }

    const FilterScene& m_scene;
    FaceId m_face;
    Level m_level;
    int m_group;
};

QueryCost latticeLinearAnswer(const FilterScene& scene,
                              const QueryEllipse& ellipse,
                              FaceId face,
                              int group,
                              GroupValue& value)
{
    // The circle of the ellipse's area.
    const LevelBlend levels = levelBlend(ellipse, std::sqrt(ellipse.determinant), kHexlinKernel, 1);
    const int base = scene.level(face).log2();
    const int fine = std::min(levels.fine, base);
    const float coarse = levels.fine <= base ? levels.coarseWeight : 0;
    QueryCost cost{static_cast<float>(fine), 3};
    if (coarse < 1) {
        HexlinFace(scene, face, Level(fine), group).add(ellipse.uv, 1 - coarse, value);
    }
    if (coarse > 0) {
        HexlinFace(scene, face, Level(fine - 1), group).add(ellipse.uv, coarse, value);
        cost.taps += 3;
    }
    return cost;
}

} // namespace

MethodEntry latticeLinearMethod()
{
    MethodEntry entry;
    entry.name = "lattice-linear";
    entry.title = "Lattice-linear";
    entry.about = "Linear between texel centroids and vertex averages, two levels blended, as wide "
                  "as the circle of the footprint's area.";
    entry.claims = {.affineKept = Claim::Yes,
                    .rotationFree = Claim::Yes,
                    .edgeContinuous = Claim::Yes,
                    .levelContinuous = Claim::Yes};
    entry.make = [](double) { return perQueryMethod(latticeLinearAnswer); };
    return entry;
}

} // namespace trixel
