// SPDX-License-Identifier: GPL-3.0-or-later
//
// Which faces the probes of lines fall on: straight over the mesh, both ways.
#pragma once

#include "core/filter/filter_surface.h"
#include "core/filter/probe_line.h"

#include <cstddef>
#include <cstdint>

namespace trixel {

/// Probes that follow each other along a line within one face: a piece of it. Structure of arrays.
struct Pieces
{
    /// Probes that there is room for the pieces of, be they placed once or twice.
    static constexpr std::size_t kMostProbes = 8192;
    static constexpr std::size_t kRoom = 2 * kMostProbes + 16;

    std::size_t count = 0;
    alignas(64) double u[kRoom], v[kRoom];       ///< of the first probe
    alignas(64) double perU[kRoom], perV[kRoom]; ///< from probe to probe
    alignas(64) double begin[kRoom], end[kRoom]; ///< numbers of the side's probes
    alignas(64) double share[kRoom];             ///< of a probe's step that lies on the surface
    alignas(64) std::int64_t face[kRoom];
    /// Of the line's side; may have more in the upper half.
    alignas(64) std::int64_t id[kRoom];

    std::size_t side(std::size_t piece) const { return std::size_t(id[piece]) & 0xFFFFFFFFU; }
    std::size_t probes(std::size_t piece) const
    {
        return static_cast<std::size_t>(end[piece] - begin[piece]);
    }
};

/// Faces that a line may run through to a side; beyond them is as beyond a border.
inline constexpr int kMostSegments = 512;

/// A vertex no further to the left of a line counts as right of it, as one on the line does; in
/// parts of the edge crossed before, across the line.
inline constexpr double kSideRounding = 1e-12;

/// Adds the pieces of one line, at least one, with care for borders. A probe stands for the step
/// around it; where a border cuts that, it moves to the middle of what is left and counts for as
/// much.
/// \param side  id of the side ahead; the one back has the next
void placeProbes(const FilterSurface& surface,
                 const ProbeLine& line,
                 std::size_t side,
                 Pieces& pieces);

} // namespace trixel
