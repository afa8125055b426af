// SPDX-License-Identifier: GPL-3.0-or-later
//
// The rows of a face under a window, several at a time. Compiled once for each kind of processor
// (Highway).
#if defined(TRIXEL_WINDOW_ROWS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef TRIXEL_WINDOW_ROWS_INL_H
#undef TRIXEL_WINDOW_ROWS_INL_H
#else
#define TRIXEL_WINDOW_ROWS_INL_H
#endif

#include "core/filter/half_lattice.h"
#include "core/filter/window_taps-inl.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace trixel {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using RowTag = hn::CappedTag<float, 8>;

/// Rows are cut into pieces of four texels, which wait here to be weighed in whole vectors, for a
/// row under a narrow ellipse has few texels.
class WaitingPieces
{
public:
    WaitingPieces(const LevelTexels& texels,
                  Level level,
                  const GaussianWindow& window,
                  const GroupValue& reference)
        : m_texels(texels)
        , m_window(window)
        , m_channels(reference)
        , m_weight(hn::Zero(WideTag()))
        // Whole pieces are read also where a row ends within one: that must not be the end of
        // the face's texels. Finer levels are followed by coarser ones.
        , m_readsWhole(texels.stride != 0 && level.log2() > 1)
    {
    }

    /// As many rows as a vector has lanes, in texels; those with a count of 0 or less are none.
    /// \param step     from one texel to the next, in standard deviations
    /// \param foot     where the row is nearest to the centre, from its first texel
    /// \param height2  squared distance of the row's line
    /// \param first    packed index of its first texel
    HWY_INLINE void addRows(float step,
                            hn::Vec<RowTag> counts,
                            hn::Vec<RowTag> foot,
                            hn::Vec<RowTag> height2,
                            hn::Vec<hn::RebindToSigned<RowTag>> first)
    {
        constexpr RowTag d;
        constexpr hn::RebindToSigned<RowTag> di;
        auto start = hn::Mul(foot, hn::Set(d, -step));
        m_taps += static_cast<std::uint64_t>(
            hn::GetLane(hn::SumOfLanes(d, hn::Max(counts, hn::Zero(d)))));
        for (auto more = hn::Gt(counts, hn::Zero(d)); !hn::AllFalse(d, more);
             more = hn::Gt(counts, hn::Zero(d))) {
            if (m_count + hn::Lanes(d) > kRoom) {
                flush();
            }
            hn::CompressStore(start, more, d, m_starts + m_count);
            hn::CompressStore(height2, more, d, m_heights + m_count);
            hn::CompressStore(counts, more, d, m_counts + m_count);
            hn::CompressStore(first, hn::RebindMask(di, more), di, m_firsts + m_count);
            hn::StoreU(hn::Set(d, step), d, m_steps + m_count);
            m_count += static_cast<std::uint32_t>(hn::CountTrue(d, more));
            start = hn::Add(start, hn::Set(d, 4 * step));
            counts = hn::Sub(counts, hn::Set(d, 4));
            first = hn::Add(first, hn::Set(di, 4));
        }
    }

    /// \param area  of a texel
    HWY_INLINE void addTo(WindowSums& sums, double area)
    {
        flush();
        m_channels.addTo(m_spilled, 1);
        m_spilled.weight += static_cast<double>(hn::GetLane(hn::SumOfLanes(WideTag(), m_weight)));
        for (std::size_t c = 0; c < kGroupChannels; ++c) {
            sums.values[c] += area * m_spilled.values[c];
        }
        sums.weight += area * m_spilled.weight;
        sums.taps += m_taps;
    }

private:
    static constexpr std::uint32_t kRoom = 128;
    static constexpr std::uint32_t kSpare = 16; ///< whole vectors are written
    static constexpr std::uint64_t kMostInFloat = 4096;

    HWY_INLINE void flush()
    {
        for (std::uint32_t k = m_count; k % 4 != 0; ++k) {
            m_counts[k] = 0;
            m_starts[k] = 0;
            m_heights[k] = 0;
            m_firsts[k] = 0;
        }
        if (m_readsWhole) {
            addWholePieces();
        } else {
            addSinglePieces();
        }
        m_count = 0;
        if (m_taps - m_spilled.taps > kMostInFloat) {
            m_channels.moveTo(m_spilled);
            m_spilled.weight +=
                static_cast<double>(hn::GetLane(hn::SumOfLanes(WideTag(), m_weight)));
            m_weight = hn::Zero(WideTag());
            m_spilled.taps = m_taps;
        }
    }

    HWY_INLINE void addWholePieces()
    {
        HWY_ALIGN float weights[16];
        for (std::uint32_t k = 0; k < m_count; k += 4) {
            weigh(k, weights);
            for (std::uint32_t j = 0; j < 4; ++j) {
                const auto first = static_cast<std::size_t>(m_firsts[k + j]);
                m_channels.addFour(weights + 4 * std::size_t{j},
                                   m_texels.values + kGroupChannels * first);
            }
        }
    }

    HWY_INLINE void addSinglePieces()
    {
        HWY_ALIGN float weights[16];
        const std::size_t stride = m_texels.stride;
        for (std::uint32_t k = 0; k < m_count; k += 4) {
            weigh(k, weights);
            for (std::uint32_t j = 0; j < 16; ++j) {
                if (weights[j] > 0) {
                    const auto first = static_cast<std::size_t>(m_firsts[k + j / 4]);
                    m_channels.addOne(weights[j], m_texels.values + stride * (first + j % 4));
                }
            }
        }
    }

    /// Weights of the texels of four pieces.
    HWY_INLINE void weigh(std::uint32_t piece, float* weights)
    {
        constexpr WideTag d;
#if HWY_TARGET == HWY_SCALAR
        for (std::uint32_t k = 0; k < 16; ++k) {
            const std::uint32_t own = piece + k / 4;
            const float at = static_cast<float>(k % 4);
            const float s = at * m_steps[own] + m_starts[own];
            const auto w = m_window.weight(d, hn::Set(d, s * s + m_heights[own]));
            weights[k] = at < m_counts[own] ? hn::GetLane(w) : 0;
            m_weight = hn::Add(m_weight, hn::Set(d, weights[k]));
        }
#else
        alignas(64) static constexpr float kPlaces[16] = {
            0, 1, 2, 3, 0, 1, 2, 3, 0, 1, 2, 3, 0, 1, 2, 3};
        const auto at = hn::Load(d, kPlaces);
        for (std::size_t k = 0; k < 16; k += hn::Lanes(d)) {
            const auto which = hn::SetTableIndices(d, kFourEach + k);
            const auto each = [&](const float* four) HWY_ATTR {
                return hn::TableLookupLanes(hn::LoadDup128(d, four + piece), which);
            };
            const auto s = hn::MulAdd(at, each(m_steps), each(m_starts));
            const auto q = hn::MulAdd(s, s, each(m_heights));
            const auto inside = hn::Lt(at, each(m_counts));
            const auto w = hn::IfThenElseZero(inside, m_window.weight(d, q));
            m_weight = hn::Add(m_weight, w);
            hn::Store(w, d, weights + k);
        }
#endif
    }

    const LevelTexels& m_texels;
    WindowVectors m_window;
    ChannelSums m_channels;
    hn::Vec<WideTag> m_weight;
    bool m_readsWhole;
    WindowSums m_spilled;
    std::uint64_t m_taps = 0;
    std::uint32_t m_count = 0;
    HWY_ALIGN float m_starts[kRoom + kSpare];
    HWY_ALIGN float m_steps[kRoom + kSpare];
    HWY_ALIGN float m_heights[kRoom + kSpare];
    HWY_ALIGN float m_counts[kRoom + kSpare]; ///< texels left in the row from here on
    HWY_ALIGN std::int32_t m_firsts[kRoom + kSpare];
};

/// Adds every run of texels of a row whose centroids lie within `radius` of the origin. Cost
/// follows the rows under the circle.
HWY_INLINE void addRowsInCircle(const HalfLattice& lattice, double radius, WaitingPieces& pieces)
{
    constexpr RowTag d;
    constexpr hn::RebindToSigned<RowTag> di;
    const bool lower = lattice.half == TexelHalf::Lower;
    const double resolution = lattice.level.resolution();
    const glm::dvec2 along = lattice.alongRow;
    const double inverseSquare = 1 / glm::dot(along, along);
    const double inverseLength = std::sqrt(inverseSquare);
    // Row y's line lies height + y heightPerRow from the origin, its side being the sign, and comes
    // nearest to it at column middle + y middlePerRow.
    const auto side = [&](glm::dvec2 p)
                          HWY_ATTR { return (p.x * along.y - p.y * along.x) * inverseLength; };
    const double height = side(lattice.origin);
    const double heightPerRow = side(lattice.perRow);
    const double middle = -glm::dot(lattice.origin, along) * inverseSquare;
    const double middlePerRow = -glm::dot(lattice.perRow, along) * inverseSquare;
    const double rowsPerHeight = 1 / heightPerRow;
    const double one = (-radius - height) * rowsPerHeight;
    const double other = (radius - height) * rowsPerHeight;
    const double least = std::max(std::min(one, other), lower ? 0.0 : 1.0); // upper row 0 is empty
    const double most = std::min(std::max(one, other), resolution - 1);
    if (!(least <= most)) {
        return;
    }
    const auto step = static_cast<float>(1 / inverseLength);
    const auto rowLength = static_cast<std::int32_t>(lattice.level.resolution());
    const auto end = static_cast<std::int32_t>(most) + 1;
    const auto lanes = static_cast<std::int32_t>(hn::Lanes(d));
    const auto ahead = hn::Iota(d, 0);
    for (auto y = static_cast<std::int32_t>(std::ceil(least)); y < end; y += lanes) {
        // In double to the first of these rows, and from a column near to where it is nearest:
        // floats do for what is left.
        const double nearest = middle + y * middlePerRow;
        const double column = std::floor(std::max(0.0, std::min(nearest, resolution - 1)));
        const double far = resolution - (lower ? 1 : 0) - y - column;
        const auto h = hn::MulAdd(ahead,
                                  hn::Set(d, static_cast<float>(heightPerRow)),
                                  hn::Set(d, static_cast<float>(height + y * heightPerRow)));
        const auto foot = hn::MulAdd(ahead,
                                     hn::Set(d, static_cast<float>(middlePerRow)),
                                     hn::Set(d, static_cast<float>(nearest - column)));
        const auto height2 = hn::Mul(h, h);
        const auto left = hn::Sub(hn::Set(d, static_cast<float>(radius * radius)), height2);
        const auto reach = hn::Mul(hn::Sqrt(hn::Max(left, hn::Zero(d))),
                                   hn::Set(d, static_cast<float>(inverseLength)));
        const auto diagonal = hn::Sub(hn::Set(d, static_cast<float>(far)), ahead);
        const auto leastColumn = lower ? hn::Set(d, static_cast<float>(-column)) : diagonal;
        const auto mostColumn =
            lower ? diagonal : hn::Set(d, static_cast<float>(resolution - 1 - column));
        const auto begin = hn::Ceil(hn::Max(hn::Sub(foot, reach), leastColumn));
        const auto last = hn::Floor(hn::Min(hn::Add(foot, reach), mostColumn));
        const auto count = hn::IfThenElseZero(hn::FirstN(d, static_cast<std::size_t>(end - y)),
                                              hn::Add(hn::Sub(last, begin), hn::Set(d, 1)));
        const auto first =
            hn::Add(hn::ConvertTo(di, begin),
                    hn::Add(hn::Mul(hn::Iota(di, 0), hn::Set(di, rowLength)),
                            hn::Set(di, y * rowLength + static_cast<std::int32_t>(column))));
        pieces.addRows(step, count, hn::Sub(foot, begin), height2, first);
    }
}

} // namespace HWY_NAMESPACE
} // namespace trixel
HWY_AFTER_NAMESPACE();

#endif
