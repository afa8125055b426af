// SPDX-License-Identifier: GPL-3.0-or-later
//
// What probes read beyond a face's own level: its texels. Vertex averages of the base blur by more
// than the narrowest footprints are wide; one level beyond them stands hexlin, the linear
// interpolation between vertex, middle of an edge and centroid of the texel:
//   f = (1 - 2 q - r) P + 3 r T + 2 (q - r) M,
// p >= q >= r the barycentrics within texel T, P and Q the vertices of p and q, M the middle of PQ:
// the mean of T and of T', its neighbour across PQ. On the edges of a face M is the mean of P and
// Q, so that f is what vertex averages give there and neighbours agree whatever their levels.
#pragma once

#include "core/filter/probe_walk.h"

#include <cstddef>
#include <cstdint>

namespace trixel {

/// Two texels of the base that a probe reads, and how much they count; nothing: it reads none.
struct TexelReads
{
    static constexpr std::size_t kRoom = 3 * kRoomPerLine;

    alignas(64) std::uint32_t own[kRoom]; ///< packed order
    alignas(64) std::uint32_t other[kRoom];
    alignas(64) float ownWeight[kRoom];
    alignas(64) float otherWeight[kRoom];
};

/// Shares of a probe's weight that its three vertices have: two beside each other in a row of the
/// lattice, then the one below (upper texels) or above them.
struct VertexWeights
{
    float* first;
    float* second;
    float* third;
};

/// Finds the texels of those probes of a line whose face is coarser than its fine level, and takes
/// from their vertices what the texels get.
///
/// \param weights  of the base's vertices, from the line's first probe on; changed
/// \param at       place of that probe among the reads
/// \return         texels that are read
std::size_t findTexels(const ProbeArrays& probes,
                       const ProbeRange& range,
                       VertexWeights weights,
                       std::size_t at,
                       TexelReads& reads);

} // namespace trixel
