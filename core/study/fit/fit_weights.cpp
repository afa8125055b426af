// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/fit/fit_weights.h"

#include "core/filter/half_lattice.h"
#include "core/filter/query_ellipse.h"
#include "core/filter/unfolding.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <unordered_map>

namespace trixel {
namespace {

constexpr double kCut = 3.5;
/// Times that the cut is doubled in search of a texel.
constexpr int kMostSearches = 16;

/// The whole numbers n in [low, high) with |offset + n step| ≤ reach.
std::pair<int, int> within(double offset, double step, double reach, int low, int high)
{
    if (!(std::abs(step) > 0)) {
        return std::abs(offset) <= reach ? std::pair(low, high) : std::pair(low, low);
    }
    // Counted from `low` on: truncation is quicker than rounding where the processor has none.
    const double middle = -offset / step - low;
    const double half = reach / std::abs(step);
    const double count = high - low;
    const double first = middle - half;
    const double last = middle + half;
    if (!(last >= 0) || !(first < count)) {
        return {low, low};
    }
    const int begin = first <= 0 ? 0 : static_cast<int>(first) + (first > static_cast<int>(first));
    const int end = last >= count ? high - low : static_cast<int>(last) + 1;
    return {low + begin, low + std::max(begin, std::min(end, high - low))};
}

} // namespace

class WeightBlock::Builder
{
public:
    Builder(WeightBlock& block, const FilterScene& scene)
        : m_block(block)
        , m_scene(scene)
    {
    }

    void addPoint(const FilterQueries& points, std::size_t index)
    {
        const QueryEllipse ellipse = queryEllipse(m_scene, points, index);
        const EllipseFrame frame(ellipse);
        const std::size_t first = m_block.m_weights.size();
        m_sum = 0;
        m_offset = 0;
        double cut = kCut;
        for (int search = 0; search < kMostSearches && !(m_sum > 0); ++search) {
            const auto places =
                m_unfolding.unfold(m_scene.surface(), points.face[index], ellipse, frame, cut);
            m_unit = places.front().doubleArea();
            for (const PlacedFace& place : places) {
                addHalf(place, TexelHalf::Lower, cut);
                addHalf(place, TexelHalf::Upper, cut);
            }
            m_offset = cut * cut;
            cut *= 2;
        }
        for (std::size_t k = first; k < m_block.m_weights.size(); ++k) {
            m_block.m_weights[k] = static_cast<float>(m_block.m_weights[k] / m_sum);
        }
        m_block.m_begin.push_back(static_cast<std::uint32_t>(m_block.m_runs.size()));
    }

private:
    void addHalf(const PlacedFace& place, TexelHalf half, double cut)
    {
        const Level level = m_scene.level(place.face);
        const HalfLattice lattice(half, level, place.origin(), place.e1(), place.e2());
        const auto side = static_cast<int>(level.resolution());
        const double step = glm::length(lattice.alongRow);
        const glm::dvec2 along = lattice.alongRow / step;
        const glm::dvec2 across(-along.y, along.x);
        const double height = glm::dot(lattice.origin, across);
        const double perRow = glm::dot(lattice.perRow, across);
        const double area = place.doubleArea() / m_unit / level.texelCount();
        const double change = std::exp(-step * step);
        const auto [rowBegin, rowEnd] = within(height, perRow, cut, 0, side);
        for (int y = rowBegin; y < rowEnd; ++y) {
            const double h = height + y * perRow;
            const double reach2 = cut * cut - h * h;
            if (!(reach2 > 0)) {
                continue;
            }
            const double start =
                glm::dot(lattice.origin + static_cast<double>(y) * lattice.perRow, along);
            // Of row y the first R-y texels of the packed square are lower ones.
            const bool lower = half == TexelHalf::Lower;
            const auto [from, to] = within(
                start, step, std::sqrt(reach2), lower ? 0 : side - y, lower ? side - y : side);
            if (from >= to) {
                continue;
            }
            m_block.m_runs.push_back(
                {firstOf(place.face) + static_cast<std::uint32_t>(y * side + from),
                 static_cast<std::uint32_t>(to - from)});
            // From one texel to the next a Gaussian changes by a factor that itself changes by one.
            const double d = start + from * step;
            double weight = area * std::exp((m_offset - h * h - d * d) / 2);
            double ratio = std::exp(-step * (d + step / 2));
            for (int x = from; x < to; ++x) {
                m_sum += weight;
                m_block.m_weights.push_back(static_cast<float>(weight));
                weight *= ratio;
                ratio *= change;
            }
        }
    }

    std::uint32_t firstOf(FaceId face)
    {
        const auto [at, isNew] = m_first.try_emplace(indexOf(face), m_block.m_texels);
        if (isNew) {
            const std::uint32_t count = m_scene.level(face).texelCount();
            m_block.m_ranges.push_back({face, m_block.m_texels, count});
            m_block.m_texels += count;
        }
        return at->second;
    }

    WeightBlock& m_block;
    const FilterScene& m_scene;
    Unfolding m_unfolding;
    std::unordered_map<std::size_t, std::uint32_t> m_first;
    double m_unit = 1; ///< area that others are relative to
    double m_sum = 0;
    double m_offset = 0; ///< squared distance that weights are relative to
};

WeightBlock::WeightBlock(const FilterScene& scene, const FilterQueries& points)
{
    Builder builder(*this, scene);
    for (std::size_t k = 0; k < points.size(); ++k) {
        builder.addPoint(points, k);
    }
    m_weights.shrink_to_fit();
    m_runs.shrink_to_fit();
}

void WeightBlock::look(std::span<const Quad> texels, std::span<Quad> seen) const
{
    check(texels.size() == m_texels && seen.size() == pointCount(), "one of each");
    const float* weight = m_weights.data();
    for (std::size_t p = 0; p < pointCount(); ++p) {
        Quad even(0); // two chains of sums, for one waits for its own last addition
        Quad odd(0);
        for (std::uint32_t r = m_begin[p]; r < m_begin[p + 1]; ++r) {
            const Quad* texel = texels.data() + m_runs[r].first;
            const std::uint32_t count = m_runs[r].count;
            std::uint32_t k = 0;
            for (; k + 1 < count; k += 2) {
                even += weight[k] * texel[k];
                odd += weight[k + 1] * texel[k + 1];
            }
            if (k < count) {
                even += weight[k] * texel[k];
            }
            weight += count;
        }
        seen[p] = even + odd;
    }
}

void WeightBlock::spread(std::span<const Quad> points, std::span<Quad> texels) const
{
    check(texels.size() == m_texels && points.size() == pointCount(), "one of each");
    const float* weight = m_weights.data();
    for (std::size_t p = 0; p < pointCount(); ++p) {
        const Quad point = points[p];
        for (std::uint32_t r = m_begin[p]; r < m_begin[p + 1]; ++r) {
            Quad* texel = texels.data() + m_runs[r].first;
            for (std::uint32_t k = 0; k < m_runs[r].count; ++k) {
                texel[k] += *weight++ * point;
            }
        }
    }
}

void WeightBlock::spreadSquares(std::span<const float> points, std::span<float> texels) const
{
    check(texels.size() == m_texels && points.size() == pointCount(), "one of each");
    const float* weight = m_weights.data();
    for (std::size_t p = 0; p < pointCount(); ++p) {
        for (std::uint32_t r = m_begin[p]; r < m_begin[p + 1]; ++r) {
            float* texel = texels.data() + m_runs[r].first;
            for (std::uint32_t k = 0; k < m_runs[r].count; ++k, ++weight) {
                texel[k] += *weight * *weight * points[p];
            }
        }
    }
}

} // namespace trixel
