// SPDX-License-Identifier: GPL-3.0-or-later
//
// The edges of texels, and who lies across them. A texel numbers its edges as a face does, from its
// own corners (`corners`): edge e runs from corner e to the next. Lower and upper texels that meet
// call the edge between them by the same number.
#pragma once

#include "core/lattice/texel.h"

#include <optional>

namespace trixel {

/// The texel across an edge, inside the face; nothing where that edge lies on the face's own edge
/// of the same number.
/// \param texel  valid at that level (checked)
std::optional<TexelCoord> texelAcross(Level level, TexelCoord texel, LocalEdge edge);

/// The texel at a place along a face's edge: 0 at the edge's start, R - 1 at its end (checked). It
/// is a lower one, and the edge is its own of that number.
TexelCoord texelAlong(Level level, LocalEdge edge, std::uint32_t place);

/// The inverse, of a texel that lies along that edge (checked).
std::uint32_t placeAlong(Level level, LocalEdge edge, TexelCoord texel);

} // namespace trixel
