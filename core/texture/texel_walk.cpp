// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/texture/texel_walk.h"

#include "core/texture/texel_neighbours.h"

namespace trixel {

std::optional<TexelWalk::Step>
TexelWalk::across(const WalkedSurface& surface, LocalEdge edge, Landing landing, Turn turn) const
{
    const auto met = texelsAcross(surface, m_here.place, edge);
    if (!met) {
        return std::nullopt;
    }
    const TexelPlace place = landing == Landing::AtStart ? TexelPlace{met->face, met->first}
                             : landing == Landing::AtEnd ? TexelPlace{met->face, met->last}
                                                         : met->middle();
    return Step{place, met->edge, turn};
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
