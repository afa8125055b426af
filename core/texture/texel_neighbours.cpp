// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/texture/texel_neighbours.h"

namespace trixel {

TexelPlace TexelsAcross::middle() const
{
    if (count == 1) {
        return {face, first};
    }
    // Theirs run the other way: the first has the highest place.
    return {face, texelAlong(level, edge, placeAlong(level, edge, last) + count / 2)};
}

std::optional<TexelsAcross>
texelsAcross(const WalkedSurface& surface, const TexelPlace& place, LocalEdge edge)
{
    const Level level = surface.level(place.face);
    if (const auto inside = texelAcross(level, place.texel, edge)) {
        return TexelsAcross{place.face, level, edge, *inside, *inside, 1};
    }
    const auto neighbour = surface.adjacency.neighbour(place.face, edge);
    if (!neighbour) {
        return std::nullopt;
    }
    const Level other = surface.level(neighbour->face);
    const std::uint32_t mirrored = level.resolution() - 1 - placeAlong(level, edge, place.texel);
    TexelsAcross across{neighbour->face, other, neighbour->edge, {}, {}, 1};
    if (other < level) {
        const std::uint32_t along = mirrored >> (level.log2() - other.log2());
        across.first = across.last = texelAlong(other, neighbour->edge, along);
        return across;
    }
    const int finer = other.log2() - level.log2();
    across.count = 1U << finer;
    const std::uint32_t lowest = mirrored << finer;
    across.first = texelAlong(other, neighbour->edge, lowest + across.count - 1);
    across.last = texelAlong(other, neighbour->edge, lowest);
    return across;
}

} // namespace trixel
