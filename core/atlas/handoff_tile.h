// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/atlas/atlas_tile.h"

namespace trixel {

/// A sample of a face in the hand-off atlas: it lies at (u,v) = (i,j) / N. Those with i, j >= 0 and
/// i + j <= N are the face's own, vertices and edges among them; the rest are padding about it.
struct HandOffSample
{
    int i = 0;
    int j = 0;

    bool operator==(const HandOffSample&) const = default;
};

/// Two faces share a square tile of an atlas that plain uvs address.
enum class HandOffSlot : std::uint8_t { First, Second };

/// The square that two faces of N intervals an edge share: the first lies in its lower left, the
/// second, turned by half a turn, in its upper right. With P pixels of padding:
///   first:  pixel (i + P, j + P)
///   second: pixel (S - 1 - (i + P), S - 1 - (j + P)),   i, j >= -P, i + j <= N + P, S = N + 3P + 2
/// A face keeps its orientation, and its uvs end at pixel centres: bilinear look-ups inside it
/// read its own samples, and of the padding only those next to its diagonal.
class HandOffTile
{
public:
    /// \param intervals  N, at least 1; \param padding  P, at least 1 (both checked)
    HandOffTile(std::uint32_t intervals, std::uint32_t padding);

    int intervals() const { return m_intervals; }
    int padding() const { return m_padding; }
    /// Width and height in pixels.
    std::uint32_t side() const
    {
        return static_cast<std::uint32_t>(m_intervals + 3 * m_padding + 2);
    }

    /// Whether the tile stores a sample.
    bool holds(HandOffSample sample) const
    {
        return sample.i >= -m_padding && sample.j >= -m_padding &&
               sample.i + sample.j <= m_intervals + m_padding;
    }
    /// Where a sample is stored. \pre holds(sample) (checked)
    AtlasPixel pixel(HandOffSlot slot, HandOffSample sample) const;
    /// Where a point of a face lies, in pixels of the tile; pixel centres are at 1/2.
    glm::dvec2 position(HandOffSlot slot, glm::dvec2 uv) const;

private:
    int m_intervals;
    int m_padding;
};

} // namespace trixel
