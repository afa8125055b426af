// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/texture/vertex_averages.h"

#include "core/texture/chain_cache.h"

#include <algorithm>
#include <array>

namespace trixel {
namespace {

using Sum = std::array<double, kGroupChannels>;

void add(const float* texel, Sum& sum)
{
    for (std::size_t c = 0; c < sum.size(); ++c) {
        sum[c] += double{texel[c]};
    }
}

void store(const Sum& sum, int count, float* value)
{
    for (std::size_t c = 0; c < sum.size(); ++c) {
        value[c] = static_cast<float>(sum[c] / count);
    }
}

float* vertex(Level level, LatticePoint at, float* values)
{
    return values + kGroupChannels * latticeVertex(level, at.i, at.j);
}

/// Adds the face's texels around vertex k of an edge, 0 < k < R: two lower ones on the edge and
/// the upper one between them.
void addOnEdge(const LevelTexels& texels, Level level, LocalEdge edge, std::uint32_t k, Sum& sum)
{
    const auto texel = [&](std::uint32_t x, std::uint32_t y) {
        return texels.texel(static_cast<TexelIndex>(x + y * level.resolution()));
    };
    const std::uint32_t r = level.resolution();
    const std::uint32_t last = r - 1;
    switch (edge) {
    case LocalEdge::E0: // upper (k - 1, 0)
        add(texel(k - 1, 0), sum);
        add(texel(k, 0), sum);
        add(texel(last, last - (k - 1)), sum);
        return;
    case LocalEdge::E1: // upper (r - 1 - k, k - 1)
        add(texel(r - k, k - 1), sum);
        add(texel(r - 1 - k, k), sum);
        add(texel(last - (k - 1), last - (r - 1 - k)), sum);
        return;
    case LocalEdge::E2: // upper (0, r - 1 - k)
        break;
    }
    add(texel(0, r - k), sum);
    add(texel(0, r - 1 - k), sum);
    add(texel(last - (r - 1 - k), last), sum);
}

TexelIndex cornerTexel(Level level, std::uint8_t corner)
{
    const std::uint32_t last = level.resolution() - 1;
    return static_cast<TexelIndex>(corner == 0   ? 0
                                   : corner == 1 ? last
                                                 : last * level.resolution());
}

} // namespace

template <class Mips>
std::size_t BasicVertexAverages<Mips>::row(FaceId face,
                                           Level level,
                                           std::uint32_t j,
                                           std::uint32_t i0,
                                           std::uint32_t i1,
                                           float* values) const
{
    const std::uint32_t r = level.resolution();
    if (j == 0 || j + 1 >= r) {
        return 0;
    }
    i0 = std::max(i0, 1U);
    i1 = std::min(i1, r - 1 - j);
    if (i0 > i1) {
        return 0;
    }
    insideRow(face, level, j, i0, i1, vertex(level, {i0, j}, values));
    return i1 - i0 + 1;
}

template <class Mips>
void BasicVertexAverages<Mips>::insideRow(FaceId face,
                                          Level level,
                                          std::uint32_t j,
                                          std::uint32_t i0,
                                          std::uint32_t i1,
                                          float* first) const
{
    const std::uint32_t r = level.resolution();
    const LevelTexels texels = m_mips.texels(face, level, m_group);
    const std::ptrdiff_t right = texels.stride;
    const std::ptrdiff_t up = right * static_cast<std::ptrdiff_t>(r);
    // Lower texel (i,j) lies at column i, row j of the packed square; upper texel (i,j) at column
    // R-1-j, row R-1-i, so that a step along i is one row down there.
    const float* lower = texels.values + right * std::ptrdiff_t{i0} + up * std::ptrdiff_t{j};
    const float* upper = texels.values + right * (std::ptrdiff_t{r} - 1 - std::ptrdiff_t{j}) +
                         up * (std::ptrdiff_t{r} - 1 - std::ptrdiff_t{i0});
    float* value = first;
    for (std::uint32_t i = i0; i <= i1; ++i) {
        for (int c = 0; c < kGroupChannels; ++c) {
            const double sum = (double{lower[c]} + double{(lower - right)[c]}) +
                               (double{(lower - up)[c]} + double{(upper + up)[c]}) +
                               (double{(upper + right)[c]} + double{(upper + up + right)[c]});
            value[c] = static_cast<float>(sum / 6);
        }
        lower += right;
        upper -= up;
        value += kGroupChannels;
    }
}

template <class Mips>
Level BasicVertexAverages<Mips>::edgeBase(FaceId face, LocalEdge edge) const
{
    const Level own = m_mips.level(face);
    const auto across = m_adjacency.neighbour(face, edge);
    return across ? std::min(own, m_mips.level(across->face)) : own;
}

template <class Mips>
void BasicVertexAverages<Mips>::onEdgeOf(
    FaceId face, LocalEdge edge, Level level, std::uint32_t k, float* values) const
{
    edgeValue(face, edge, level, k, vertex(level, onEdge(level, edge, k), values));
}

template <class Mips>
void BasicVertexAverages<Mips>::edgeValue(
    FaceId face, LocalEdge edge, Level level, std::uint32_t k, float* value) const
{
    Sum sum{};
    addOnEdge(m_mips.texels(face, level, m_group), level, edge, k, sum);
    const auto across = m_adjacency.neighbour(face, edge);
    if (across) {
        const LevelTexels there = m_mips.texels(across->face, level, m_group);
        addOnEdge(there, level, across->edge, level.resolution() - k, sum);
    }
    store(sum, across ? 6 : 3, value);
}

template <class Mips>
void BasicVertexAverages<Mips>::derive(LocalEdge edge,
                                       Level base,
                                       const float* baseValues,
                                       Level level,
                                       std::uint32_t k,
                                       float* values)
{
    const int steps = level.log2() - base.log2();
    const std::uint32_t span = 1U << steps;
    const auto at = [&](std::uint32_t place) {
        const LatticePoint point = onEdge(base, edge, std::min(place, base.resolution()));
        return baseValues + kGroupChannels * latticeVertex(base, point.i, point.j);
    };
    const float* from = at(k >> steps);
    const float* to = at((k >> steps) + 1);
    const double t = static_cast<double>(k & (span - 1)) / span;
    between(from, to, t, vertex(level, onEdge(level, edge, k), values));
}

template <class Mips>
void BasicVertexAverages<Mips>::between(const float* from, const float* to, double t, float* value)
{
    for (int c = 0; c < kGroupChannels; ++c) {
        // What does not count may be anything, also NaN.
        value[c] = t > 0 ? static_cast<float>((1 - t) * from[c] + t * to[c]) : from[c];
    }
}

template <class Mips>
Level BasicVertexAverages<Mips>::ringBase(FaceId face, std::uint8_t corner) const
{
    Level coarsest(Level::kMax);
    for (const Corner& other : m_rings.corners(m_rings.ring({face, corner}))) {
        coarsest = std::min(coarsest, m_mips.level(other.face));
    }
    return coarsest;
}

template <class Mips>
void BasicVertexAverages<Mips>::atCorner(
    FaceId face, std::uint8_t corner, Level ringBase, Level level, float* values) const
{
    const LatticePoint at = onEdge(level, static_cast<LocalEdge>(corner), 0);
    cornerValue(face, corner, ringBase, level, vertex(level, at, values));
}

template <class Mips>
void BasicVertexAverages<Mips>::cornerValue(
    FaceId face, std::uint8_t corner, Level ringBase, Level level, float* value) const
{
    const auto ring = m_rings.corners(m_rings.ring({face, corner}));
    const Level from = std::min(level, ringBase);
    Sum sum{};
    for (const Corner& other : ring) {
        add(m_mips.texels(other.face, from, m_group).texel(cornerTexel(from, other.index)), sum);
    }
    store(sum, static_cast<int>(ring.size()), value);
}

template class BasicVertexAverages<FloatMips>;
template class BasicVertexAverages<FaceMips>;

} // namespace trixel
