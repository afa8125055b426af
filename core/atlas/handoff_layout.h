// SPDX-License-Identifier: GPL-3.0-or-later
//
// Where the faces of a mesh lie in a hand-off atlas: one that any program can show which knows no
// more than uvs and bilinear filtering. Hardware can't interpolate packed texels across the
// diagonal of their square, so faces are sampled anew, each a plain triangle of pixels.
#pragma once

#include "core/atlas/atlas_layout.h"
#include "core/atlas/handoff_tile.h"

namespace trixel {

struct HandOffOptions
{
    std::uint32_t samplesPerTexel = 2; ///< intervals along an edge for every texel along it
    std::uint32_t padding = 2;        ///< pixels about every face, for mips and anisotropic filters
    std::uint32_t largestPage = 8192; ///< most pixels of a page along either side
    bool powerOfTwo = false; ///< pages of sides that are powers of two, none above the largest
};

/// A triangle in a page.
struct HandOffPlace
{
    std::uint32_t page = 0;
    AtlasPixel origin; ///< of its tile
    HandOffSlot slot{};
    /// Which edge lies along the tile's diagonal: E1, E2 or E0 for 0, 1, 2.
    std::uint8_t turn = 0;
};

/// A sample of a face as its tile counts: the face's three coordinates go round.
HandOffSample turned(HandOffSample sample, std::uint8_t turn, int intervals);
/// The inverse.
HandOffSample turnedBack(HandOffSample sample, std::uint8_t turn, int intervals);

class HandOffLayout
{
public:
    /// \param intervals  N of every face, at least 1 (checked)
    /// Fails, naming a face, where a page cannot hold its tile, or where there would be more than
    /// 65,535 pages.
    static Result<HandOffLayout> plan(FaceMap<std::uint32_t> intervals,
                                      const HandOffOptions& options);

    const HandOffOptions& options() const { return m_options; }
    std::span<const AtlasPage> pages() const { return m_pages; }
    std::size_t faceCount() const { return m_places.size(); }
    HandOffTile tile(FaceId face) const { return {m_intervals[face], m_options.padding}; }
    const HandOffPlace& place(FaceId face) const { return m_places[face]; }

    /// Lays another edge along the diagonal. \param turn  0, 1 or 2 (checked)
    void setTurn(FaceId face, std::uint8_t turn)
    {
        check(turn < 3, "a turn of a triangle");
        m_places[face].turn = turn;
    }

    /// Where a sample is stored in the face's page.
    AtlasPixel pixel(FaceId face, HandOffSample sample) const;
    /// Where a point of a face lies in its page, in pixels; pixel centres are at 1/2.
    glm::dvec2 position(FaceId face, glm::dvec2 uv) const;

    /// Samples of the faces, padding not counted.
    std::uint64_t usefulSamples() const;
    /// Pixels of all pages.
    std::uint64_t allocatedPixels() const;
    /// The one in parts of the other; 1 where there are none.
    double occupancy() const;

private:
    HandOffOptions m_options;
    FaceMap<std::uint32_t> m_intervals;
    FaceMap<HandOffPlace> m_places;
    std::vector<AtlasPage> m_pages;
};

} // namespace trixel
