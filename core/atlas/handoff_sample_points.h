// SPDX-License-Identifier: GPL-3.0-or-later
//
// Which samples of a hand-off atlas are one point of the surface, and who takes them.
#pragma once

#include "core/atlas/handoff_layout.h"
#include "core/filter/filter_surface.h"

#include <optional>
#include <vector>

namespace trixel {

/// V0, V1 or V2 of a face of N intervals.
HandOffSample cornerSample(std::uint8_t corner, int intervals);

/// Sample k of an edge, counted from its start; 0 and N are its vertices.
HandOffSample edgeSample(LocalEdge edge, int k, int intervals);

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

    /// Those of the face that belong to it.
    std::vector<HandOffSample> ownSamples(FaceId face) const;

private:
    const HandOffLayout& m_layout;
    const FilterSurface& m_surface;
};

} // namespace trixel
