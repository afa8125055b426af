// SPDX-License-Identifier: GPL-3.0-or-later
//
// The inner loop of EWA: texels of one level under a window, over many faces.
#pragma once

#include "core/filter/ewa_kernel.h"

#include <cstdint>
#include <span>

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

    /// Adds the faces' texels of a level, or of their base where that is coarser
    /// (`addUnderWindow`).
    /// \return false where it takes more than `mostTaps`; the sum then is of no use
    bool add(const FilterScene& scene,
             std::span<const PlacedFace> places,
             const GaussianWindow& window,
             int level,
             int group,
             std::uint64_t mostTaps);

    double weight() const { return m_sums.weight; }
    std::uint64_t taps() const { return m_sums.taps; }
    /// \param channel  in [0, 4); weight() is not 0
    float mean(std::size_t channel) const
    {
        return m_reference[channel] + static_cast<float>(m_sums.values[channel] / m_sums.weight);
    }

private:
    GroupValue m_reference;
    WindowSums m_sums;
};

} // namespace trixel
