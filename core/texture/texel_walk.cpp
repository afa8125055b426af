// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/texture/texel_walk.h"

namespace trixel {

std::optional<TexelWalk::Step>
TexelWalk::across(const WalkedSurface& surface, LocalEdge edge, Landing landing, Turn turn) const
{
    const auto& [face, texel] = m_here.place;
    const Level level = surface.level(face);
    if (const auto inside = texelAcross(level, texel, edge)) {
        return Step{{face, *inside}, edge, turn};
    }
    const auto neighbour = surface.adjacency.neighbour(face, edge);
    if (!neighbour) {
        return std::nullopt;
    }
    // The neighbour runs along the edge the other way.
    const Level other = surface.level(neighbour->face);
    const std::uint32_t place = level.resolution() - 1 - placeAlong(level, edge, texel);
    std::uint32_t entry = 0;
    if (other < level) {
        entry = place >> (level.log2() - other.log2());
    } else {
        const int finer = other.log2() - level.log2();
        const std::uint32_t first = place << finer;
        const std::uint32_t last = first + (1U << finer) - 1;
        entry = landing == Landing::AtStart ? last
                : landing == Landing::AtEnd ? first
                                            : (first + last + 1) / 2;
    }
    return Step{
        {neighbour->face, texelAlong(other, neighbour->edge, entry)}, neighbour->edge, turn};
}

bool TexelWalk::turnTo(const WalkedSurface& surface, Turn turn, Landing landing)
{
    const LocalEdge right = nextEdge(m_here.entered);
    const auto step = across(surface, turn == Turn::Right ? right : nextEdge(right), landing, turn);
    if (!step) {
        return false;
    }
    m_steps.push_back(m_here);
    m_here = *step;
    return true;
}

bool TexelWalk::right(const WalkedSurface& surface)
{
    // Leaving by an edge, its start lies to the right.
    return turnTo(surface, Turn::Right, Landing::AtStart);
}

bool TexelWalk::left(const WalkedSurface& surface)
{
    return turnTo(surface, Turn::Left, Landing::AtEnd);
}

bool TexelWalk::ahead(const WalkedSurface& surface)
{
    const Turn other = m_here.turn == Turn::Right ? Turn::Left : Turn::Right;
    return turnTo(surface, other, Landing::Middle);
}

bool TexelWalk::back(const WalkedSurface& surface)
{
    if (!m_steps.empty()) {
        m_here = m_steps.back();
        m_steps.pop_back();
        return true;
    }
    const auto step = across(surface, m_here.entered, Landing::Middle, m_here.turn);
    if (step) {
        m_here = *step;
    }
    return step.has_value();
}

} // namespace trixel
