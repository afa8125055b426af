// SPDX-License-Identifier: GPL-3.0-or-later
//
// Which samples of a hand-off atlas are one point of the surface, and who takes them.
#pragma once

#include "core/atlas/handoff_layout.h"
#include "core/filter/filter_surface.h"

#include <array>
#include <cstdint>
#include <optional>

namespace trixel {

/// V0, V1 or V2 of a face of N intervals.
HandOffSample cornerSample(std::uint8_t corner, int intervals);

/// Sample k of an edge, counted from its start; 0 and N are its vertices.
HandOffSample edgeSample(LocalEdge edge, int k, int intervals);

/// Samples with i, j >= 0 and i + j <= N, numbered row after row from j = 0.
std::uint64_t sampleCount(int intervals);
/// \param number  below `sampleCount` (checked)
HandOffSample sampleOfNumber(std::uint64_t number, int intervals);
/// The sample that follows in that order.
inline HandOffSample nextSample(HandOffSample sample, int intervals)
{
    return sample.i + sample.j < intervals ? HandOffSample{sample.i + 1, sample.j}
                                           : HandOffSample{0, sample.j + 1};
}

/// The face's own sample that is nearest to a point, inside or not.
HandOffSample nearestSample(glm::dvec2 uv, int intervals);

/// Samples that faces share belong to one of them: of an edge, to the face with fewer intervals
/// (the finer one interpolates), of two alike to the lower one; of a vertex, to the lowest of the
/// faces about it. Refers to both.
class HandOffOwners
{
public:
    HandOffOwners(const HandOffLayout& layout, const FilterSurface& surface)
        : m_layout(layout)
        , m_surface(surface)
    {
    }

    /// The neighbour that an edge's samples belong to, if it isn't the face.
    std::optional<EdgeNeighbour> edgeOwner(FaceId face, LocalEdge edge) const;
    Corner vertexOwner(Corner corner) const;

    /// Which of its corners and edges belong to the face; all that lies within does.
    struct Border
    {
        std::array<bool, 3> corners{};
        std::array<bool, 3> edges{};

        /// \param sample  one of the face's own, of so many intervals
        bool owns(HandOffSample sample, int intervals) const;
    };
    Border border(FaceId face) const;

private:
    const HandOffLayout& m_layout;
    const FilterSurface& m_surface;
};

} // namespace trixel
