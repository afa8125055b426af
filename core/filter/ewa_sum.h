// SPDX-License-Identifier: GPL-3.0-or-later
//
// The inner loop of EWA: texels of one level under a window, face by face.
#pragma once

#include "core/filter/gaussian_window.h"
#include "core/filter/placed_face.h"
#include "core/filter/query_filter.h"

#include <array>
#include <cstdint>

namespace trixel {

/// Weighted mean of texels.
class EwaSum
{
public:
    /// \param reference  a value near the answer, which the sums count from: where every texel has
    ///                   it, so has the mean, to the bit
    explicit EwaSum(const GroupValue& reference)
        : m_reference(reference)
    {
    }

    /// Adds the face's texels of a level, or of its base where that is coarser. The covariance of
    /// the ellipse is lessened by that of a texel's box beyond a base texel's, so that box and
    /// Gaussian together spread as far as the Gaussian alone over the base level; by half at most.
    /// Weights are times texel area and of equal mass whatever was subtracted.
    void add(const FilterScene& scene,
             const PlacedFace& place,
             const GaussianWindow& window,
             int level,
             int group);

    double weight() const { return m_weight; }
    std::uint64_t taps() const { return m_taps; }
    /// \param channel  in [0, 4); weight() is not 0
    float mean(std::size_t channel) const
    {
        return m_reference[channel] + static_cast<float>(m_values[channel] / m_weight);
    }

private:
    GroupValue m_reference;
    std::array<double, kGroupChannels> m_values{};
    double m_weight = 0;
    std::uint64_t m_taps = 0;
};

} // namespace trixel
