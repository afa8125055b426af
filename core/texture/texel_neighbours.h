// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/texture/texel_walk.h"

#include <cstdint>
#include <optional>

namespace trixel {

/// Who lies across one edge of a texel: one texel or, across a mesh edge to a finer face, several
/// side by side.
struct TexelsAcross
{
    FaceId face{};
    Level level;      ///< of that face
    LocalEdge edge{}; ///< what they call the edge
    TexelCoord first; ///< at the start of the edge, as the texel asked about runs along it
    TexelCoord last;  ///< at its end; `first` where there is one
    std::uint32_t count = 1;

    /// The middle one: where one goes straight across; of an even number the one nearer the start.
    TexelPlace middle() const;

    bool operator==(const TexelsAcross&) const = default;
};

/// \param place  a texel of the surface (checked)
/// \return       nothing at a border
std::optional<TexelsAcross>
texelsAcross(const WalkedSurface& surface, const TexelPlace& place, LocalEdge edge);

} // namespace trixel
