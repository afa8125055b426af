// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/lattice/texel_edges.h"

#include "core/base/check.h"

namespace trixel {
namespace {

TexelCoord cell(std::uint32_t i, std::uint32_t j, TexelHalf half)
{
    return {static_cast<std::uint16_t>(i), static_cast<std::uint16_t>(j), half};
}

} // namespace

std::optional<TexelCoord> texelAcross(Level level, TexelCoord texel, LocalEdge edge)
{
    check(isValid(level, texel), "a texel of the face");
    const bool lower = texel.half == TexelHalf::Lower;
    const TexelHalf other = lower ? TexelHalf::Upper : TexelHalf::Lower;
    // An edge 1 lies within its cell; edges 0 and 2 lie between cells, below or left of a lower
    // texel, above or right of an upper one.
    if (edge == LocalEdge::E1) {
        const bool onBorder = lower && texel.i + texel.j + 1U == level.resolution();
        return onBorder ? std::nullopt : std::optional(cell(texel.i, texel.j, other));
    }
    const bool along = edge == LocalEdge::E0;
    if (!lower) {
        return cell(texel.i + (along ? 0U : 1U), texel.j + (along ? 1U : 0U), other);
    }
    if ((along ? texel.j : texel.i) == 0) {
        return std::nullopt;
    }
    return cell(texel.i - (along ? 0U : 1U), texel.j - (along ? 1U : 0U), other);
}

TexelCoord texelAlong(Level level, LocalEdge edge, std::uint32_t place)
{
    check(place < level.resolution(), "a place along the edge");
    const std::uint32_t rest = level.resolution() - 1 - place;
    switch (edge) {
    case LocalEdge::E0:
        return cell(place, 0, TexelHalf::Lower);
    case LocalEdge::E1:
        return cell(rest, place, TexelHalf::Lower);
    case LocalEdge::E2:
        break;
    }
    return cell(0, rest, TexelHalf::Lower);
}

std::uint32_t placeAlong(Level level, LocalEdge edge, TexelCoord texel)
{
    check(isValid(level, texel) && texel.half == TexelHalf::Lower &&
              !texelAcross(level, texel, edge),
          "a texel along that edge");
    switch (edge) {
    case LocalEdge::E0:
        return texel.i;
    case LocalEdge::E1:
        return texel.j;
    case LocalEdge::E2:
        break;
    }
    return level.resolution() - 1 - texel.j;
}

} // namespace trixel
